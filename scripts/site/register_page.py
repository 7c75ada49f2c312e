# SPDX-License-Identifier: Apache-2.0
"""The page of registers, from what hls/registers/make_registers.py makes of registers.rdl."""

import json
import subprocess
import sys
import tempfile

from rtl_pages import escaped
from tree import ROOT


def read_registers():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, ROOT / "hls/registers/make_registers.py", folder],
                       check=True)
        with open(f"{folder}/registers.json", encoding="ascii") as file:
            return json.load(file)


def bits_of(field):
    high = field["low"] + field["bits"] - 1
    return str(high) if field["bits"] == 1 else f"{high}:{field['low']}"


def register_page(docs):
    page = "registers.md"
    made = read_registers()
    axes = made["axes"]
    text = ["# Registers",
            docs.linked("Registers of [`motion_system`](rtl/motion_system.sv), made from "
                        "[`registers.rdl`](hls/registers/registers.rdl). Words have 32 bits, "
                        "addresses count bytes. How a host uses them: "
                        "[the wire](sysc/wire/README.md).", "", page),
            f"Registers of an axis are there once for each of {axes['number']}, "
            f"{axes['stride']} bytes apart."]
    for register in made["registers"]:
        access = ("r" if register["read"] else "") + ("w" if register["write"] else "")
        address = f"0x{register['address']:03x}" + (" and on, an axis" if register["axis"] else "")
        text += [f"## {register['name']}", f"`{address}`, {access}. {register['what']}"]
        rows = []
        for field in register["fields"]:
            notes = [escaped(field["what"])]
            notes += ["a one clears it"] if field["clears"] else []
            notes += [escaped("; ".join(str(value) for value in field["values"]))]
            rows.append(f"| {bits_of(field)} | `{field['name']}` | {field['reset']:#x} | "
                        + "; ".join(note for note in notes if note) + " |")
        if rows:
            text.append("| bits | field | reset | |\n|---|---|---|---|\n" + "\n".join(rows))
    docs.write(page, "\n\n".join(text))
    return page
