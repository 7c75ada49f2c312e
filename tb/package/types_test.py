#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""types_test.py [TESTS ..]: what type checkers read of the package curvecore: every function has
its types, they have a meaning, and the extension's stub names what the extension has."""

import ast
import dataclasses
import importlib
import inspect
import pathlib
import typing
import unittest

import curvecore

FOLDER = pathlib.Path(curvecore.__file__).parent
MODULES = ("curvecore", "curvecore.curve", "curvecore.bench", "curvecore._program",
           "curvecore.pytest_plugin")


def functions(module):
    """Functions and methods that a module defines, with their names."""
    for name, one in vars(module).items():
        if getattr(one, "__module__", None) != module.__name__:
            continue
        if inspect.isfunction(one):
            yield name, one
        elif inspect.isclass(one):
            for inner, method in vars(one).items():
                method = method.fget if isinstance(method, property) else method
                made = inner in ("__init__", "__eq__", "__repr__", "__hash__", "__replace__",
                                 "__setattr__", "__delattr__") and dataclasses.is_dataclass(one)
                if inspect.isfunction(method) and not made:
                    yield f"{name}.{inner}", method


def untyped(function):
    """Parameters without a type, and "return"; types that name nothing raise NameError."""
    hints = typing.get_type_hints(function)
    names = [name for name in inspect.signature(function).parameters if name != "self"]
    return [name for name in [*names, "return"] if name not in hints]


def stub_names(text):
    """Names of a stub: {"": those of the module, CLASS: those of a class}."""
    tree = ast.parse(text)
    found = {"": {node.name for node in tree.body if hasattr(node, "name")}}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = {inner.name for inner in node.body} - {"__init__"}
    return found


def module_names(module):
    def public(of):
        return {name for name in vars(of) if not name.startswith("_")}

    found = {"": public(module)}
    for name in found[""]:
        if inspect.isclass(getattr(module, name)):
            found[name] = public(getattr(module, name))
    return found


class TypesTest(unittest.TestCase):
    def test_every_function_has_its_types(self):
        count = 0
        for name in MODULES:
            for where, function in functions(importlib.import_module(name)):
                with self.subTest(function=f"{name}.{where}"):
                    self.assertEqual(untyped(function), [])
                    count += 1
        self.assertGreater(count, 35)

        def bare(one, two: int):
            return one + two
        self.assertEqual(untyped(bare), ["one", "return"])

        def unknown() -> "NoSuchType":  # noqa: F821
            pass
        with self.assertRaises(NameError):
            untyped(unknown)

    def test_public_names_are_there_and_said(self):
        for name in curvecore.__all__:
            self.assertTrue(getattr(curvecore, name).__doc__, name)
        public = {name for name, one in vars(curvecore).items() if not name.startswith("_")
                  and getattr(one, "__module__", one.__name__ if inspect.ismodule(one) else "")
                  .startswith("curvecore")}
        self.assertEqual(public - {"bench", "pytest_plugin", "Option"}, set(curvecore.__all__))
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_the_stub_names_what_the_extension_has(self):
        stub = (FOLDER / "_native.pyi").read_text()
        self.assertEqual(stub_names(stub), module_names(curvecore._native))
        for less in ("    def draw(", "def ship_from("):
            self.assertNotEqual(stub_names(stub.replace(less, less.replace("def ", "def other_"))),
                                module_names(curvecore._native))


if __name__ == "__main__":
    unittest.main()
