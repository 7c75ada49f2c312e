#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vhdl_component.py TOP < NETLIST.json: the component of a module for VHDL, in package
TOP_component. Reads what Yosys' write_json says of its ports; vectors are std_logic_vector."""
import json
import sys

DIRECTIONS = {"input": "in", "output": "out"}


def port(name, one, width):
    bits = len(one["bits"])
    kind = "std_logic" if bits == 1 and not one.get("upto") else \
        f"std_logic_vector({bits - 1} downto 0)"
    return f"      {name:<{width}} : {DIRECTIONS[one['direction']]:<3} {kind}"


def component(top, ports):
    width = max(map(len, ports))
    lines = ";\n".join(port(name, one, width) for name, one in ports.items())
    return (f"-- SPDX-License-Identifier: Apache-2.0\n"
            f"-- The component of {top}.v: made by scripts/flat.sh of curvecore with that file.\n"
            f"library ieee;\nuse ieee.std_logic_1164.all;\n\n"
            f"package {top}_component is\n  component {top} is\n    port (\n{lines}\n    );\n"
            f"  end component;\nend package;\n")


def main(top):
    print(component(top, json.load(sys.stdin)["modules"][top]["ports"]), end="")


if __name__ == "__main__":
    main(*sys.argv[1:])
