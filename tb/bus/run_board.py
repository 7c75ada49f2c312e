#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A board's top, as scripts/synth.sh --board makes it, under Icarus, behind a UART from another
project:

    run_board.py BOARD REGISTERS_JSON FOLDER
"""

import os
import pathlib
import sys

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))
from synthesis import microcode  # noqa: E402
from synthesis.board_files import top  # noqa: E402
from synthesis.boards import TOP, board_named  # noqa: E402
from synthesis.cores import sources  # noqa: E402

# The bench's clock is that of the design; Icarus has no PLL of the device either.
PLL = """
module pll (input clock_in, output clock_out, output locked);
  assign clock_out = clock_in;
  assign locked = 1'b1;
endmodule
"""


def main():
    name, registers, folder = sys.argv[1:]
    board = board_named(name, {"MultiplierForm": "0"})  # Icarus has no cells of the device
    text = pathlib.Path(folder) / "top.v"
    made = pathlib.Path(folder).resolve()
    settings = microcode.make(TOP, board.settings, made, made / "microcode.log")
    for parameter, file in microcode.FILES.items():
        if parameter in settings:
            settings[parameter] = f'"{made / file}"'
    text.write_text(top(board, settings) + PLL)
    runner = get_runner("icarus")
    runner.build(sources=[*sources("uart_line", TOP), text], hdl_toplevel="top", build_dir=folder,
                 always=True, build_args=["-g2012"], timescale=("1ns", "1ps"))
    results = runner.test(hdl_toplevel="top", test_module="test_board", build_dir=folder,
                          test_dir=HERE, results_xml=f"{folder}/results.xml",
                          extra_env={"BOARD": name, "REGISTERS_JSON": registers,
                                     "WORDS_VERSION": "0",
                                     "PYTHONPATH": os.pathsep.join(map(str, (HERE, sys.path[0])))})
    tests, failed = get_results(pathlib.Path(results))
    sys.exit(0 if tests > 0 and failed == 0 else 1)


if __name__ == "__main__":
    main()
