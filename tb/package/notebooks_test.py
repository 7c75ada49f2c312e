#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""notebooks_test.py ROOT [TESTS ..]: the notebooks of sysc/python run from top to bottom, as a
reader runs them, and are kept without what they printed."""

import ast
import contextlib
import io
import json
import os
import pathlib
import sys
import unittest

import matplotlib

matplotlib.use("Agg")
FOLDER = pathlib.Path(sys.argv[1]) / "sysc/python/notebooks"


def cells(name):
    return json.loads((FOLDER / f"{name}.ipynb").read_text())["cells"]


def code_of(cell):
    return "".join(cell["source"]) if cell["cell_type"] == "code" else ""


def run(cells_of_book):
    """Runs the code. Returns what it prints, the value of a last line, too."""
    names, printed = {}, io.StringIO()
    with contextlib.redirect_stdout(printed):
        for number, cell in enumerate(cells_of_book):
            tree = ast.parse(code_of(cell))
            last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
            exec(compile(tree, f"cell {number}", "exec"), names)
            if last is not None:
                value = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names)
                if value is not None and not code_of(cell).rstrip().endswith(";"):
                    print(value)
    return printed.getvalue()


class NotebooksTest(unittest.TestCase):
    def test_are_kept_without_outputs(self):
        books = sorted(file.stem for file in FOLDER.glob("*.ipynb"))
        self.assertEqual(books, ["core_in_a_bench", "widths"], "each has its test")
        for name in books:
            self.assertIn("SPDX-License-Identifier: Apache-2.0", cells(name)[0]["source"][0])
            for cell in cells(name):
                self.assertEqual(cell.get("outputs", []), [], name)
                self.assertIsNone(cell.get("execution_count"), name)

    def test_widths(self):
        said = run(cells("widths"))
        self.assertRegex(said, r"\n\d+ nm at most\n")
        self.assertRegex(said, r"\n4 18 \d\S+ nm \d+")
        self.assertRegex(said, r"\necp5-25: take Order=\d CoefBits=\d\d .* proven to \d\S* nm")
        self.assertRegex(said, r"'CoefBits': \d\d")

    def test_core_in_a_bench(self):
        book = cells("core_in_a_bench")
        said = run(book)
        self.assertIn("1 test, 0 failed\n", said)
        self.assertRegex(said, r"sample \d+, axis 0: \w+ is -\d+, the kernel's \d+")
        changed = [dict(cell, source=code_of(cell).replace("{-d_i, ", "{d_i, ")) for cell in book]
        with self.assertRaises(AssertionError):
            run(changed)


if __name__ == "__main__":
    os.environ.setdefault("COCOTB_ANSI_OUTPUT", "0")
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
