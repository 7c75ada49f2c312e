#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The schemas of sysc/formats: closed, every field described, and what curvecore writes fits them
while nothing that is a little off does.

    formats_test.py CURVECORE [unittest's options]
"""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from check_json import SCHEMAS, flaw, schema

TABLE = SCHEMAS.parents[1] / "ref/curves/clothoid.net"
PROGRAM = "G21 G90 G64 P0.1 F1200 M3 S900\nG1 X4 Y1 A5\nG2 X6 Y3 I0 J2\nG5 X9 Y0 I2 J0 P0 Q-2\nM2\n"
COMMANDS = {
    "report": ("run", "part.ngc", "--on", "kernel"),
    "segments": ("run", "part.ngc", "--on", "kernel"),
    "words": ("words", "part.ngc", "--build", "serial"),
    "core": ("choose", "--error", "1um", "--radius", "300mm", "--feed", "10m/min", "--device",
             "up5k"),
    "join": ("join", "a.ngc", "b.ngc"),
    "curve": ("curve", "check", "clothoid", "--row", "T=1,0,0", "--row", "N=0,1,0", "--row",
              "kappa=0.05,0.05,0.05", "--row", "sigma=0.001"),
    "explore": ("explore", "part.ngc", "--segment-queue", "1024", "--profile-queue", "256,4096"),
    "compare": ("compare", "part.ngc", "--set", "CoefBits=30", "--error", "10nm"),
    "choose": ("choose", "--error", "1um", "--radius", "300mm", "--feed", "10m/min", "--device",
               "up5k"),
}
CLOTHOID = ("--row", "T=1,0,0", "--row", "N=0,1,0", "--row", "kappa=0,0,0", "--row", "sigma=1e-9")
# Further forms of results: exit status, schema, command.
FORMS = (
    (3, "choose", ("choose", "--error", "0.1nm", "--radius", "10m", "--feed", "100m/min",
                   "--device", "up5k")),
    (0, "compare", ("compare", "--curves", "splines", "--set", "CoefBits=18,36", "--scheme",
                    "anchored,rk4", "--samples", "1000", "-o", "curves")),
    (0, "curve", ("curve", "check", "TABLE")),
    (0, "curve", ("curve", "check", "TABLE", *CLOTHOID)),
    (1, "curve", ("curve", "check", "TABLE", *CLOTHOID[:-1], "sigma=0.9", "--step-exponent", "27")),
    (0, "report", ("plan", "part.ngc", "-o", "plan")),
    (0, "report", ("run", "part.ngc", "--on", "kernel", "-q", "-o", "kernel")),
    (0, "report", ("curve", "run", "clothoid", *CLOTHOID, "--length", "5mm", "--on", "kernel",
                   "-o", "curve")),
)
FILES_ELSEWHERE = ("stream", "home", "board")  # of tests at a wire: tb/wire


def objects(node):
    """Every schema of an object inside a schema."""
    if isinstance(node, dict):
        if "object" in node.get("type", ()):
            yield node
        for value in node.values():
            yield from objects(value)
    elif isinstance(node, list):
        for value in node:
            yield from objects(value)


def damaged(data):
    """Copies of some JSON, each with one place changed: (what, copy)."""
    def places(node, path=()):
        yield path, node
        items = node.items() if isinstance(node, dict) else enumerate(
            node[:1] if isinstance(node, list) else ())
        for key, value in items:
            yield from places(value, (*path, key))

    def changed(path, change):
        root = [copy.deepcopy(data)]
        node, key = root, 0
        for step in path:
            node, key = node[key], step
        node[key] = change(node[key])
        return root[0]

    for path, node in places(data):
        where = "/".join(map(str, path))
        if isinstance(node, dict):
            yield f"{where}: a field too much", changed(path, lambda d: {**d, "surplus": "x"})
            yield f"{where}: no object", changed(path, lambda d: [d])
        elif path:
            yield f"{where}: another type", changed(path, lambda d: {"surplus": d})


class Formats(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.folder = pathlib.Path(cls.kept.name)
        (cls.folder / "part.ngc").write_text(PROGRAM)
        for name in "ab":
            (cls.folder / f"{name}.ngc").write_text(
                f"G21 G90 F600\nG0 X{ord(name)} Y0\nG1 X{ord(name) + 1} Y1\nM2\n")

    def written(self, name):
        out = self.folder / name
        done = subprocess.run([CURVECORE, *COMMANDS[name], "-q", "-o", str(out)], cwd=self.folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((out / f"{name}.json").read_text())

    def test_every_schema_is_closed_and_describes_its_fields(self):
        names = sorted(file.name.split(".")[0] for file in SCHEMAS.glob("*.schema.json"))
        self.assertEqual(names, sorted([*COMMANDS, *FILES_ELSEWHERE]))
        for name in names:
            for one in objects(schema(name)):
                self.assertIn("additionalProperties", one, name)
                self.assertIsNot(one["additionalProperties"], True, name)
                for field, of in one.get("properties", {}).items():
                    self.assertIn("description", of, f"{name}: {field}")
                self.assertLessEqual(set(one.get("required", ())), set(one.get("properties", ())))

    def printed(self, command, status=0):
        """Returns what --json prints, which is JSON and nothing else."""
        command = [str(TABLE) if word == "TABLE" else word for word in command]
        done = subprocess.run([CURVECORE, *command, "--json"], cwd=self.folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout)

    def test_what_is_printed_is_what_is_written(self):
        for name, command in COMMANDS.items():
            if name in ("segments", "core"):  # what run and choose write besides
                continue
            with self.subTest(name):
                data = self.printed((*command, "-o", f"printed-{name}"))
                file = "report" if name == "join" else name
                written = json.loads(
                    (self.folder / f"printed-{name}" / f"{file}.json").read_text())
                self.assertEqual(data, written)
                self.assertEqual(flaw(file, data), "")

    def test_every_form_of_a_result_fits(self):
        for status, name, command in FORMS:
            with self.subTest(command):
                self.assertEqual(flaw(name, self.printed(command, status)), "")

    def test_what_is_no_result_is_refused(self):
        for action in ("kernel", "derive"):
            done = subprocess.run([CURVECORE, "curve", action, "clothoid", "--json"],
                                  cwd=self.folder, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("--json: of run and check", done.stderr)

    def test_what_is_written_fits_and_nothing_that_is_a_little_off_does(self):
        for name in COMMANDS:
            data = self.written(name)
            with self.subTest(name):
                self.assertEqual(flaw(name, data), "")
                for field in schema(name)["required"]:
                    rest = {key: value for key, value in data.items() if key != field}
                    self.assertNotEqual(flaw(name, rest), "", f"without {field}")
                for what, other in damaged(data):
                    self.assertNotEqual(flaw(name, other), "", what)


CURVECORE = str(pathlib.Path(sys.argv.pop(1)).resolve())
if __name__ == "__main__":
    unittest.main()
