#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vectors_test.py CURVECORE DATA IVERILOG VVP [TESTS ..]: what `curvecore vectors` writes, read by
numpy and by $readmemh."""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

import numpy

CURVECORE, DATA, IVERILOG, VVP = sys.argv[1], pathlib.Path(sys.argv[2]), *sys.argv[3:5]
DEMO = DATA / "demo.ngc"
ODD = ["--set", "Order=4", "--set", "CoefBits=24", "--set", "PositionBits=29", "--set",
       "GuardBits=7", "--set", "AuxAxes=2", "--unit", "10nm"]
READER = """module reader;
  reg [{bits}-1:0] words [0:{count}-1];
  integer i;
  initial begin
    $readmemh("{file}", words);
    for (i = 0; i < {count}; i = i + 1) $display("%h", words[i]);
  end
endmodule
"""


def words_of(file):
    """Words of a memory file: hexadecimal digits, remarks from // to the end of the line."""
    lines = [line.split("//")[0].strip() for line in file.read_text().splitlines()]
    return [int(line, 16) for line in lines if line]


def fields(words, axes, bits):
    """(words, axes): signed fields of words, axis 0 in the low bits."""
    rows = []
    for word in words:
        cut = [word >> axis * bits & (1 << bits) - 1 for axis in range(axes)]
        rows.append([value - (value >> bits - 1 << bits) for value in cut])
    return numpy.array(rows)


class VectorsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, command, *arguments, status=0):
        out = self.folder / command
        done = subprocess.run([CURVECORE, command, *arguments, "-q", "-o", out], check=False,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return out if status == 0 else done.stderr

    def hold_words(self, vectors, part, *arguments):
        words = self.program("words", part, *arguments)
        for name in ("segments.hex", "profile.hex", "words.json"):
            self.assertEqual((vectors / name).read_text(), (words / name).read_text(), name)
        arrays = numpy.load(vectors / "vectors.npz")
        for name in ("segments", "profile"):
            self.assertEqual(arrays[name].dtype, numpy.uint64)
            self.assertEqual(arrays[name].tolist(), words_of(words / f"{name}.hex"), name)
        return arrays

    def hold_samples(self, vectors, arrays, run, bits, guard):
        with open(run / "samples.csv", encoding="ascii") as file:
            rows = [row for row in csv.reader(file) if row[0].isdigit()]
        positions = numpy.array([[int(n) for n in row[3:]] for row in rows])
        axes = positions.shape[1]
        self.assertGreater(len(rows), 3000)
        numpy.testing.assert_array_equal(arrays["start"], positions[0])
        numpy.testing.assert_array_equal(arrays["position"], positions[1:])
        numpy.testing.assert_array_equal(fields(words_of(vectors / "positions.hex"), axes, bits),
                                         positions[1:])
        fine = fields(words_of(vectors / "fine.hex"), axes, bits + guard)
        numpy.testing.assert_array_equal(arrays["fine"], fine)
        numpy.testing.assert_array_equal((fine + (1 << guard - 1)) >> guard, positions[1:])
        self.assertEqual(arrays["ds"].tolist(), words_of(vectors / "path.hex"))
        return rows

    def test_are_words_and_what_the_rtl_draws(self):
        options = ["--sample-period", "500us"]
        vectors = self.program("vectors", DEMO, *options)
        arrays = self.hold_words(vectors, DEMO, *options)
        rows = self.hold_samples(vectors, arrays, self.program("run", DEMO, *options), 32, 10)
        way = numpy.cumsum(arrays["ds"])
        self.assertEqual(way[:100].tolist(), [int(row[2]) for row in rows[1:101]])
        with zipfile.ZipFile(vectors / "vectors.npz") as archive:
            self.assertIsNone(archive.testzip(), "checksums of the archive")

    def test_of_odd_widths_and_more_axes(self):
        part = self.folder / "part.ngc"
        part.write_text("G21 G90 F900\nG1 X5 A3\nG3 X7 Y2 I0 J2 A1 B-2\nM2\n", encoding="ascii")
        vectors = self.program("vectors", part, *ODD)
        arrays = self.hold_words(vectors, part, *ODD)
        self.hold_samples(vectors, arrays, self.program("run", part, "--on", "kernel", *ODD), 29, 7)
        head = (vectors / "fine.hex").read_text().splitlines()
        self.assertIn("sample_fine_o of part.ngc: words of 180 bits", head[0])
        self.assertIn("x [35:0] y [71:36] z [107:72] a [143:108] b [179:144]: signed, 7", head[2])

    def test_are_read_by_verilog(self):
        vectors = self.program("vectors", DATA / "arcs.ngc", "--sample-period", "10ms")
        for name, bits in (("segments", 48), ("positions", 96), ("fine", 126), ("path", 48)):
            file = vectors / f"{name}.hex"
            words = words_of(file)
            self.assertGreater(len(words), 50)
            source = self.folder / f"{name}.v"
            source.write_text(READER.format(bits=bits, count=len(words), file=file))
            subprocess.run([IVERILOG, "-o", source.with_suffix(".vvp"), source], check=True)
            shown = subprocess.run([VVP, "-n", source.with_suffix(".vvp")], check=True,
                                   capture_output=True, text=True)
            self.assertEqual(shown.stderr, "")
            self.assertEqual([int(line, 16) for line in shown.stdout.split()], words, name)

    def test_that_no_archive_holds_are_refused(self):
        slow = self.folder / "slow.ngc"
        slow.write_text("G21 G90 F1\nG1 X2\nM2\n", encoding="ascii")
        error = self.program("vectors", slow, "--sample-period", "1us", "--samples-per-tick",
                             "128", status=2)
        self.assertRegex(error, r"^curvecore: error: vectors.npz: \d+ samples are more than 4 GiB:"
                         " take a part of the program, or a longer --sample-period\n$")
        self.assertEqual([file.name for file in self.folder.iterdir()], ["slow.ngc"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[5:])
