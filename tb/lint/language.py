#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A doc comment begins with a noun or a verb: no preposition, conjunction, "what" or "false".  Doc
comments are a file's first sentence, docstrings, /// and /** in C++ and C, and in SystemVerilog
the comments of modules, packages, functions, ports and parameters."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TREES = ("ref", "hls", "rtl", "scripts", "sysc", "tb")
HEADS = """about above across after against along among around as at before behind below beneath
    beside besides between beyond by down during except for from in inside into like near of off on
    onto out outside over per since through throughout till to toward towards under until up upon
    via with within without  and although because but if nor or so than though unless when whenever
    whereas whether while yet  how that what where which who why  false none true""".split()
FIRST = r"\A(?:#!.*\n)?.*SPDX.*\n *(?://|\*|#|\"\"\") *{}"
C = (r"^(?! *///).*\n *///(?!<) ?{}", r"///< *{}", r"^ */\*\*? *{}")
DOCS = {".hpp": C, ".cpp": C, ".h": C, ".c": C, ".py": (r":\n *\"\"\"{}",), ".sv": (
    r"^ *(?:in(?:put|out)|output|parameter|localparam)\b.*?// *{}",
    r"^(?! *//).*\n *// *{}.*\n(?: *//.*\n)*(?=(?:`.*\n)* *(?:module|package|function|task)\b)")}


def faults(suffix, text):
    """Yields the line and the words of every doc comment that begins with one of HEADS."""
    for pattern in (FIRST, *DOCS.get(suffix, ())):
        pattern = pattern.format(rf"((?:{'|'.join(HEADS)})(?![\w(]).*)")
        for match in re.finditer(pattern, text, re.M | re.I):
            yield text.count("\n", 0, match.start(1)) + 1, match[1]


def main():
    found = [f"{file.relative_to(ROOT)}:{line}: {words}" for tree in TREES
             for file in sorted((ROOT / tree).rglob("*")) if file.suffix in DOCS
             for line, words in sorted(faults(file.suffix, file.read_text()))]
    print(*found, f"{len(found)} doc comments begin with a preposition or a conjunction", sep="\n")
    # One is seen in each form of each language; plain comments and later lines are not.
    head = "// SPDX\n// Of a.\n"
    seen = {
        ".hpp": head + "int b;  ///< of b\n/// Of c.\nint c;\n/// A d\n/// of e.\nint d;  // of d",
        ".h": "/* SPDX\n * Of a. */\n/* Of b. */\n/** Of c. */\n",
        ".sv": head + "module a (\n  input b  // of b\n);\n// Of c\nfunction c;\n// At d",
        ".py": '#!\n# SPDX\n"""Of a."""\ndef b():\n    """Of b."""\nc = """of c"""\n'}
    counts = [len(list(faults(suffix, text))) for suffix, text in seen.items()]
    return bool(found) or counts != [3, 3, 3, 2]


if __name__ == "__main__":
    sys.exit(main())
