# SPDX-License-Identifier: Apache-2.0
"""Way of a kernel to Verilog: clang to LLVM's intermediate language, hls_flow.translate, XLS."""

import dataclasses
import importlib.metadata
import pathlib
import re
import shutil
import subprocess

from hls_flow.translate import Function
from synthesis.cores import ROOT
from synthesis.refused import Refused
from synthesis.tools import error_of, run

CLANG = "clang++-14"
# Everything in line and unrolled, one word at a time; sums wrap, as they do in hardware.
FLAGS = ["-O2", "-fno-vectorize", "-fno-slp-vectorize", "-fno-discard-value-names", "-mllvm",
         "-unroll-threshold=1000000", "-mllvm", "-inline-threshold=1000000", "-S", "-emit-llvm"]
LANGUAGE = ["-std=c++14", "-DCURVECORE_BIT_INT", "-fwrapv", "-I", str(ROOT)]


@dataclasses.dataclass(frozen=True)
class Made:
    """Result: the file, its module, its ports."""

    file: pathlib.Path
    module: str
    inputs: list
    outputs: list
    products: int  # products left after XLS has simplified
    tools: list


def xls():
    try:
        import xls
    except ImportError:
        raise Refused("tool missing: xls-python is not installed: run scripts/setup.sh") from None
    return xls


def llvm(top, definitions, folder):
    """The text of a top in LLVM's intermediate language."""
    if not shutil.which(CLANG):
        raise Refused(f"tool missing: {CLANG} is not installed: run scripts/setup.sh")
    rolled, kernel = folder / "rolled.ll", folder / "kernel.ll"
    # The second pass turns memory, whose loops are unrolled by then, into words.
    for source in ([*LANGUAGE, *definitions, str(top), "-o", str(rolled)],
                   [str(rolled), "-o", str(kernel)]):
        run([CLANG, *FLAGS, *source], folder / "clang.log",
            lambda lines: f"clang does not take the kernel: {first_error(lines)}")
    return kernel.read_text()


def tools():
    """Versions of the tools."""
    said = subprocess.run([CLANG, "--version"], capture_output=True, text=True).stdout
    return [said.splitlines()[0], f"xls-python {importlib.metadata.version('xls-python')}"]


def first_error(lines):
    errors = [line for line in lines if " error: " in line]
    return errors[0] if errors else error_of(lines)


def pipeline(package, module, stages):
    """Verilog of a package's top function; its number of products."""
    tool = xls()
    try:
        best = tool.optimize_ir(package, module)
        made = tool.parse_ir_package(best).schedule_and_codegen(
            generator="pipeline", pipeline_stages=stages, delay_model="unit",
            with_delay_model=True, module_name=module, use_system_verilog=False,
            flop_inputs=True, flop_outputs=True, input_valid_signal="valid_i",
            output_valid_signal="valid_o", output_port_name="out_o", reset="rst_ni",
            reset_active_low=True, reset_data_path=False)
    except Exception as error:  # the binding has no class of its own
        raise Refused(f"XLS does not take the kernel: {' '.join(str(error).split())}") from None
    text = re.sub(r"\bclk\b", "clk_i", made.get_verilog_text())
    return text, len(re.findall(r" = [su]mul\(", best))


def make(wanted, folder):
    """Writes <module>.v into the folder."""
    module = f"{wanted.kernel.name}_hls"
    text = llvm(ROOT / "hls/top" / f"{wanted.kernel.top}.cpp", wanted.definitions(), folder)
    try:
        function = Function(text)
        package = function.package()
    except Refused as error:
        raise Refused(f"the kernel {error}") from None
    (folder / "kernel.ir").write_text(package)
    verilog, products = pipeline(package, module, wanted.stages)
    file = folder / f"{module}.v"
    file.write_text(verilog)
    return Made(file, module, function.inputs, function.outputs, products, tools())
