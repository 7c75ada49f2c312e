#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Registers from their one description, registers.rdl:

    make_registers.py FOLDER

writes there registers_pkg.sv, registers.h, registers.json and registers.html.
"""

import html
import json
import pathlib
import sys

from systemrdl import RDLCompileError, RDLCompiler
from systemrdl.node import RegfileNode, RegNode

READERS = """\
/* A field of a register's word, by the register's and the field's name; its bits in place, which
 * are added up; the most that it holds. */
#define CURVECORE_FIELD(word, name) \\
    (((uint32_t)(word)&CURVECORE_##name##_MASK) >> CURVECORE_##name##_LOW)
#define CURVECORE_PUT(name, value) ((uint32_t)(value) << CURVECORE_##name##_LOW)
#define CURVECORE_MOST(name) (CURVECORE_##name##_MASK >> CURVECORE_##name##_LOW)""".split("\n")
RDL = pathlib.Path(__file__).resolve().parent / "registers.rdl"
MADE = "Made by hls/registers/make_registers.py from registers.rdl, which explains the registers."


def one_line(text):
    return " ".join((text or "").split())


def sentence(node):
    return one_line(node.get_property("desc"))


def values_of(field):
    """Values of a field that have names, and what a host says of them."""
    return [{"name": value.name, "value": value.value, "text": one_line(value.rdl_name)}
            for value in field.get_property("encode") or ()]


def faults_of(register):
    """Masks of faults in a register's word, each with what a host says of it."""
    return [(value["value"] << field["low"], value["text"])
            for field in register["fields"] if field["clears"]
            for value in field["values"] or [{"value": 1, "text": field["text"]}]]


def read_registers():
    """Registers in the order of their addresses; those of axes: of axis 0. NAME[n]: NAMEn, of which
    only the first has a name in the package and the header."""
    compiler = RDLCompiler()
    compiler.compile_file(str(RDL))
    registers, axes = [], {}
    for node in compiler.elaborate("registers").top.descendants(unroll=False):
        if isinstance(node, RegfileNode):
            axes = {"number": node.array_dimensions[0], "address": node.raw_address_offset,
                    "stride": node.array_stride}
        if not isinstance(node, RegNode):
            continue
        fields = [{"name": field.inst_name, "low": field.low, "bits": field.width,
                   "clears": field.get_property("onwrite") is not None,
                   "constant": field.is_sw_readable and not field.is_sw_writable
                   and field.get_property("reset") is not None,
                   "reset": field.get_property("reset") or 0, "what": sentence(field),
                   "text": one_line(field.get_property("name")), "values": values_of(field)}
                  for field in node.fields()]
        in_axis = isinstance(node.parent, RegfileNode)
        address = node.raw_address_offset + (axes["address"] if in_axis else 0)
        numbers = range(node.array_dimensions[0]) if node.is_array else [""]
        registers += [{
            "name": f"{node.inst_name}{number}", "what": sentence(node), "axis": in_axis,
            "address": address + (number or 0) * (node.array_stride or 0),
            "read": node.has_sw_readable, "write": node.has_sw_writable, "fields": fields,
            "first": number in ("", 0)}
            for number in numbers]
    if not axes:
        raise RDLCompileError("there is no regfile: the registers of an axis")
    return registers, axes


def reset_of(register):
    return sum(field["reset"] << field["low"] for field in register["fields"])


def camel(*names):
    return "".join(part.capitalize() for name in names for part in name.lower().split("_"))


def function(name, bits, cases, default):
    """A SystemVerilog function of a word's address; cases: (names, value)."""
    lines = [f"  function automatic logic {bits}{name}(input logic [6:0] word);",
             "    case (word)"]
    for names, value in cases:
        one = " " if len(names) == 1 else "\n      "
        lines.append("      " + ",\n      ".join(names) + f":{one}{name} = {value};")
    return [*lines, f"      default: {name} = {default};", "    endcase", "  endfunction"]


def word(register):
    """Its address in the package."""
    return camel(register["name"]) if register["first"] else f"7'd{register['address'] // 4}"


def package(registers, axes):
    plain = [register for register in registers if not register["axis"]]
    lines = ["// SPDX-License-Identifier: Apache-2.0", f"// {MADE}", "`default_nettype none",
             "package registers_pkg;", "", "  // Addresses in words of 32 bits"]
    for register in plain:
        if not register["first"]:
            continue
        lines.append(f"  localparam logic [6:0] {camel(register['name'])} = "
                     f"7'd{register['address'] // 4};")
    lines += ["", "  // Axes: the first one's words, and the number of words of each", "  "
              f"localparam logic [6:0] AxisFirst = 7'd{axes['address'] // 4};",
              f"  localparam int AxisWords = {axes['stride'] // 4};"]
    for register in registers:
        if register["axis"]:
            lines.append(f"  localparam logic [1:0] Axis{camel(register['name'])} = "
                         f"2'd{(register['address'] - axes['address']) // 4};")
    lines += ["", "  // Lowest bits"]
    for register in registers:
        for field in register["fields"] if register["first"] else ():
            name = camel(register["name"], field["name"])
            lines.append(f"  localparam int {name}Low = {field['low']};")
    for what in ("read", "write"):
        names = [word(register) for register in plain if register[what]]
        done = "read" if what == "read" else "written"
        lines += ["", f"  // Words that can be {done}, without axes",
                  *function(f"can_{what}", "", [(names, "1'b1")], "1'b0")]
    resets = [((word(register),), f"32'h{reset_of(register):08x}")
              for register in plain if reset_of(register) != 0]
    lines += ["", "  // Value of a word after a reset", *function("reset_value", "[31:0] ", resets,
                                                                "32'd0")]
    return "\n".join([*lines, "", "endpackage", "`default_nettype wire", ""])


def header(registers, axes):
    lines = ["/* SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later", f" * {MADE}",
             " * Addresses in bytes; of each field its lowest bit and its mask in place. */",
             "#ifndef CURVECORE_REGISTERS_H", "#define CURVECORE_REGISTERS_H", "",
             "#include <stdint.h>", "", *READERS, "",
             f"#define CURVECORE_MOST_AXES {axes['number']}",
             f"#define CURVECORE_AXIS_STRIDE 0x{axes['stride']:x}"]
    for register in registers:
        if not register["first"]:
            continue
        prefix = "CURVECORE_AXIS_" if register["axis"] else "CURVECORE_"
        name = prefix + register["name"]
        lines += ["", f"/* {register['what']}" + (" Of axis 0." if register["axis"] else "")
                  + " */", f"#define {name} 0x{register['address']:03x}"]
        for field in register["fields"]:
            mask = ((1 << field["bits"]) - 1) << field["low"]
            lines += [f"#define {name}_{field['name'].upper()}_LOW {field['low']}",
                      f"#define {name}_{field['name'].upper()}_MASK 0x{mask:08x}u"]
            if field["constant"]:
                lines.append(f"#define {name}_{field['name'].upper()}_VALUE "
                             f"0x{field['reset']:x}u")
            lines += [f"#define {name}_{field['name'].upper()}_{value['name'].upper()} "
                      f"0x{value['value']:x}u" for value in field["values"]]
    faults = [fault for register in registers for fault in faults_of(register)]
    lines += ["", "/* All faults in a word of STATE. */",
              f"#define CURVECORE_FAULTS 0x{sum(mask for mask, _ in faults):08x}u", "",
              "/* Returns the text of one of them. */",
              "static inline const char* curvecore_fault_text(uint32_t fault) {",
              "    switch (fault) {"]
    for mask, text in faults:
        lines += [f"    case 0x{mask:08x}u:", f'        return "{text}";']
    lines += ["    default:", '        return "";', "    }", "}"]
    return "\n".join([*lines, "", "#endif", ""])


def page(registers, axes):
    rows = []
    for register in registers:
        access = "r" * register["read"] + "w" * register["write"]
        address = f"{register['address']:03x}" + (
            f" + {axes['stride']:x} n" if register["axis"] else "")
        rows.append(f"<tr class=register><td>{address}<td>{register['name']}<td>{access}<td>"
                    f"<td>{reset_of(register):x}<td>{html.escape(register['what'])}")
        for field in register["fields"]:
            high = field["low"] + field["bits"] - 1
            bits = f"{high}:{field['low']}" if field["bits"] > 1 else f"{high}"
            what = field["what"] + (" (a one clears)" if field["clears"] else "")
            what += "".join(f"; {value['value']:x}: {value['text']}" for value in field["values"])
            rows.append(f"<tr><td><td>{field['name']}<td><td>{bits}<td><td>{html.escape(what)}")
    style = ("body{font:15px sans-serif;margin:2em}table{border-collapse:collapse}"
             "td,th{padding:.2em .7em;text-align:left;vertical-align:top}"
             ".register td{border-top:1px solid #bbb;font-weight:bold}")
    return (f"<!doctype html><meta charset=ascii><title>motion_system</title><style>{style}"
            "</style><h1>Registers of motion_system</h1><table><tr><th>address<th>name<th>access"
            "<th>bits<th>reset<th>what\n" + "\n".join(rows) + "\n</table>\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    try:
        registers, axes = read_registers()
    except (RDLCompileError, OSError) as error:  # the compiler has said line and column
        print(f"{RDL}: error: {getattr(error, 'strerror', error)}", file=sys.stderr)
        return 2
    texts = {"registers_pkg.sv": package(registers, axes), "registers.h": header(registers, axes),
             "registers.json": json.dumps({"axes": axes, "registers": registers}, indent=1) + "\n",
             "registers.html": page(registers, axes)}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="ascii")
    return 0


if __name__ == "__main__":
    sys.exit(main())
