#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/hls_flow/translate.py: every instruction, run by XLS, against whole numbers; and what it
refuses, of LLVM's text and of C++."""

import itertools
import pathlib
import random
import sys
import tempfile
import unittest

import xls

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

from hls_flow.translate import Function  # noqa: E402
from hls_flow.verilog import llvm  # noqa: E402
from synthesis.refused import Refused  # noqa: E402


def function(arguments, body):
    return f"define dso_local void @f({arguments}) local_unnamed_addr #0 {{\n{body}\n}}\n"


def run(text, *words):
    """The result for the words of each input, as one number."""
    translated = Function(text)
    made = xls.parse_ir_package(translated.package()).get_function("f")
    values = [xls.Value.parse(f"bits[{port.width}]:{word:#x}")
              for port, word in zip(translated.inputs, words, strict=True)]
    return int(made.interpret(values).to_string().split(":")[-1], 0)


def signed(value, bits):
    return value - (1 << bits) if value >> (bits - 1) else value


def samples(bits):
    edges = [0, 1, (1 << bits) - 1, 1 << (bits - 1), (1 << (bits - 1)) - 1]
    numbers = random.Random(bits)
    return edges + [numbers.getrandbits(bits) for _ in range(5)]


BINARY = {
    "add": lambda a, b, n: a + b,
    "sub": lambda a, b, n: a - b,
    "mul": lambda a, b, n: a * b,
    "and": lambda a, b, n: a & b,
    "or": lambda a, b, n: a | b,
    "xor": lambda a, b, n: a ^ b,
}
SHIFTS = {
    "shl": lambda a, b, n: a << b,
    "lshr": lambda a, b, n: a >> b,
    "ashr": lambda a, b, n: signed(a, n) >> b,
}
COMPARISONS = {
    "eq": lambda a, b, n: a == b,
    "ne": lambda a, b, n: a != b,
    "ult": lambda a, b, n: a < b,
    "ule": lambda a, b, n: a <= b,
    "ugt": lambda a, b, n: a > b,
    "uge": lambda a, b, n: a >= b,
    "slt": lambda a, b, n: signed(a, n) < signed(b, n),
    "sle": lambda a, b, n: signed(a, n) <= signed(b, n),
    "sgt": lambda a, b, n: signed(a, n) > signed(b, n),
    "sge": lambda a, b, n: signed(a, n) >= signed(b, n),
}


class Instructions(unittest.TestCase):
    def two(self, operation, n, out, a, b, expected):
        text = function(f"i{n}* nocapture %a, i{n}* %b, i{out}* writeonly %r",
                        f"  %x = load i{n}, i{n}* %a, align 8, !tbaa !5\n"
                        f"  %y = load i{n}, i{n}* %b, align 8\n"
                        f"  %z = {operation} i{n} %x, %y\n"
                        f"  store i{out} %z, i{out}* %r, align 8, !tbaa !5\n  ret void")
        self.assertEqual(run(text, a, b), expected % (1 << out), (operation, n, a, b))

    def test_binary(self):
        for (name, oracle), n in itertools.product(BINARY.items(), (5, 42, 76)):
            hint = " nsw" if name in ("add", "sub", "mul") else ""
            for a, b in itertools.product(samples(n), samples(n)):
                self.two(name + hint, n, n, a, b, oracle(a, b, n))

    def test_shifts(self):
        for (name, oracle), n in itertools.product(SHIFTS.items(), (5, 42, 76)):
            for a, b in itertools.product(samples(n), range(0, n, 4)):
                self.two(name, n, n, a, b, oracle(a, b, n))

    def test_comparisons(self):
        for (name, oracle), n in itertools.product(COMPARISONS.items(), (5, 42)):
            for a, b in itertools.product(samples(n), samples(n)):
                self.two(f"icmp {name}", n, 1, a, b, int(oracle(a, b, n)))

    def test_conversions(self):
        for name, n, out in (("zext", 5, 9), ("sext", 5, 9), ("trunc", 42, 7), ("sext", 1, 3)):
            for a in samples(n) if n > 1 else (0, 1):
                text = function(f"i{n}* %a, i{out}* %r",
                                f"  %x = load i{n}, i{n}* %a\n  %y = {name} i{n} %x to i{out}\n"
                                f"  store i{out} %y, i{out}* %r\n  ret void")
                expected = signed(a, n) if name == "sext" else a
                self.assertEqual(run(text, a), expected % (1 << out), (name, a))

    def test_selection_and_constants(self):
        text = function("i8* %a, i8* %r",
                        "  %x = load i8, i8* %a\n  %c = icmp slt i8 %x, -3\n"
                        "  %d = xor i1 %c, true\n  %y = select i1 %d, i8 %x, i8 -100\n"
                        "  store i8 %y, i8* %r\n  ret void")
        for a in range(256):
            self.assertEqual(run(text, a), a if signed(a, 8) >= -3 else 156)

    def test_places(self):
        """Words of arrays, and of two results, are where they are said to be."""
        def element(name, word, count, bits):
            return f"  %{name}{word} = getelementptr inbounds [{count} x i{bits}]," \
                   f" [{count} x i{bits}]* %{name}, i64 0, i64 {word}\n"
        text = function("[3 x i12]* %a, i12* %b, [2 x i12]* %r, i12* %s",
                        element("a", 0, 3, 12) + element("a", 2, 3, 12) + element("r", 0, 2, 12)
                        + element("r", 1, 2, 12)
                        + "  %x = load i12, i12* %a0\n  %z = load i12, i12* %a2\n"
                        "  %y = load i12, i12* %b\n  store i12 %y, i12* %s\n"
                        "  store i12 %x, i12* %r0\n  store i12 %z, i12* %r1\n  ret void")
        self.assertEqual(run(text, 0x333222111, 0x444), 0x444333111)


LOADED = "  %x = load i8, i8* %a\n"
STORED = "  store i8 %x, i8* %r\n  ret void"
REFUSED = (
    ("  %y = call i8 @llvm.ctlz.i8(i8 %x, i1 false)\n", "calls a function: llvm.ctlz.i8"),
    ("  %y = tail call i8 @other(i8 %x)\n", "calls a function: other"),
    ("  %y = alloca i8\n", "keeps words in memory"),
    ("  br label %next\n\nnext:\n", "has a loop or a branch that depends on data"),
    ("  switch i8 %x, label %one [\n", "has a loop or a branch that depends on data"),
    ("  %y = udiv i8 %x, 3\n", "needs what has no translation: udiv i8 %x, 3"),
    ("  %y = add <2 x i8> %x, %x\n", "needs what has no translation: add <2 x i8>"),
    ("  %y = add i8 %x, undef\n", "undef has no value"),
    ("  store i8 %x, i8* %elsewhere\n", "keeps words in memory, or takes an element that"),
    ("  store i8 %x, i8* %r\n  %y = load i8, i8* %r\n", "reads r after writing to it"),
    ("  %y = load i4, i4* %a\n", "takes 4 bits out of the words of a"),
)
KERNELS = (
    ("for (int i = 0; i < int(a); ++i) x = x * x + a;", "has a loop or a branch that depends on"),
    ("while (x > 3) x = x - a * x;", "has a loop or a branch that depends on"),
    ("int other(int); x = other(int(x));", "calls a function: other"),
    ("static Word t[9]; x = t[int(a) & 7]; t[int(x) & 7] = a;", "keeps words in memory, or takes"),
    ("x = x / a;", "needs what has no translation: sdiv i20"),
    ("x = Word(float(a) * 2.5f);", "needs what has no translation: sitofp i20"),
)


class Refusals(unittest.TestCase):
    def test_llvm(self):
        for body, reason in REFUSED:
            with self.assertRaises(Refused) as caught:
                Function(function("i8* %a, i8* %r", LOADED + body + STORED))
            self.assertIn(reason, str(caught.exception))

    def test_functions_and_arguments(self):
        good = function("i8* %a, i8* %r", LOADED + STORED)
        self.assertEqual(run(good, 7), 7)
        for text, reason in (
                (good + good, "must become one function, not 2"), ("", "not 0"),
                (good.replace("i8* %a", "float* %a"), "an argument must be a reference to words"),
                (function("i8* %a, [2 x i8]* %s", LOADED + "  %r = getelementptr [2 x i8],"
                          " [2 x i8]* %s, i64 0, i64 1\n" + STORED), "not write word 0 of s"),
                (good.replace("  store i8 %x, i8* %r\n", ""), "has no result")):
            with self.assertRaises(Refused) as caught:
                Function(text).package()
            self.assertIn(reason, str(caught.exception))

    def test_kernels(self):
        for body, reason in KERNELS:
            with tempfile.TemporaryDirectory() as name:
                top = pathlib.Path(name) / "top.cpp"
                top.write_text("using Word = _BitInt(20);\nextern \"C\" void f(const Word& a, const"
                               f" Word& b, Word& r) {{ Word x = b; {body} r = x; }}\n")
                with self.assertRaises(Refused) as caught:
                    Function(llvm(top, [], pathlib.Path(name)))
                self.assertIn(reason, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
