# SPDX-License-Identifier: Apache-2.0
"""Translation of LLVM's intermediate language to that of XLS: one function, straight through.

The function's arguments are pointers to integers or to arrays of them, as clang 14 writes them. An
argument that is read becomes a parameter, element i in the bits from i times its width on; those
that are written become the result, the first one lowest. All else is a value of iN, and each
instruction becomes one of XLS that means the same, for every value that LLVM gives a meaning to.
"""

import dataclasses
import re

from synthesis.refused import Refused

SAME = {"add": "add", "sub": "sub", "and": "and", "or": "or", "xor": "xor",
        "shl": "shll", "lshr": "shrl", "ashr": "shra"}
EXTEND = {"zext": "zero_ext", "sext": "sign_ext"}
HINTS = r"(?:nuw |nsw |exact |inbounds )*"

DEFINE = re.compile(r"^define [^@]*@(\w+)\((.*?)\) [^()]*\{\n(.*?)^\}", re.M | re.S)
ARGUMENT = re.compile(r"(?:\[(\d+) x i(\d+)\]|i(\d+))\* .*?%([\w.]+)$")
BINARY = re.compile(rf"(\w+) {HINTS}i(\d+) (\S+), (\S+)$")
CONVERSION = re.compile(r"(zext|sext|trunc) i(\d+) (\S+) to i(\d+)$")
COMPARISON = re.compile(r"icmp (\w+) i(\d+) (\S+), (\S+)$")
SELECTION = re.compile(r"select i1 (\S+), i(\d+) (\S+), i\d+ (\S+)$")
ELEMENT = re.compile(r"getelementptr (?:inbounds )?[^,]+, [^,]+\* %([\w.]+), i64 0, i64 (\d+)$")
LOAD = re.compile(r"load i(\d+), i\d+\* %([\w.]+)(?:, .*)?$")
STORE = re.compile(r"store i(\d+) (\S+), i\d+\* %([\w.]+)(?:, .*)?$")
MEMORY = "keeps words in memory, or takes an element that depends on data"
BRANCH = "has a loop or a branch that depends on data"
UNSUPPORTED = {
    "alloca": MEMORY, "bitcast": MEMORY, "getelementptr": MEMORY, "load": MEMORY, "store": MEMORY,
    "br": BRANCH, "phi": BRANCH, "switch": BRANCH,
}


@dataclasses.dataclass(frozen=True)
class Port:
    """An argument: `count` words of `bits` bits."""

    name: str
    bits: int
    count: int

    @property
    def width(self):
        return self.bits * self.count


class Function:
    """A function of LLVM's text, translated."""

    def __init__(self, text):
        found = DEFINE.findall(text)
        if len(found) != 1:
            raise Refused(f"the kernel must become one function, not {len(found)}")
        self.name, arguments, body = found[0]
        self.ports = {port.name: port for port in map(argument, arguments.split(", "))}
        self.places = {name: (name, 0) for name in self.ports}  # pointer -> argument, element
        self.values = {}
        self.stored = {name: {} for name in self.ports}
        self.lines = []
        for line in body.splitlines():
            line = re.sub(r"^\w+:.*|, ![^,]*|, align \d+", "", line).strip()
            if line and line != "ret void":
                self.instruction(line)

    @property
    def inputs(self):
        return [port for name, port in self.ports.items() if not self.stored[name]]

    @property
    def outputs(self):
        return [port for name, port in self.ports.items() if self.stored[name]]

    def instruction(self, line):
        result, _, operation = line.rpartition(" = ")
        for form, make in ((BINARY, self.binary), (CONVERSION, self.conversion),
                           (COMPARISON, self.comparison), (SELECTION, self.selection),
                           (LOAD, self.load)):
            found = form.match(operation)
            made = found and result and make(*found.groups())
            if made:
                self.values[result] = self.node(*made)
                return
        element = ELEMENT.match(operation)
        store = STORE.match(operation)
        if element and result and element[1] in self.ports:
            self.places[result[1:]] = (element[1], int(element[2]))
        elif store:
            self.store(*store.groups())
        else:
            called = re.match(r"(?:\w+ )?call .*?@([\w.]+)", operation)
            raise Refused(f"calls a function: {called[1]}" if called else UNSUPPORTED.get(
                operation.split()[0], f"needs what has no translation: {operation}"))

    def node(self, bits, text):
        name = f"n{len(self.lines)}"
        self.lines.append(f"{name}: bits[{bits}] = {text}")
        return name

    def value(self, bits, text):
        if text in self.values:
            return self.values[text]
        text = {"true": "1", "false": "0"}.get(text, text)
        if not re.fullmatch(r"-?\d+", text):
            raise Refused(f"{text} has no value")
        return self.node(bits, f"literal(value={int(text) % (1 << int(bits))})")

    def binary(self, operation, bits, a, b):
        operands = f"{self.value(bits, a)}, {self.value(bits, b)}"
        if operation == "mul":
            return bits, f"smul({operands})"
        return operation in SAME and (bits, f"{SAME[operation]}({operands})")

    def conversion(self, operation, bits, a, to):
        a = self.value(bits, a)
        if operation == "trunc":
            return to, f"bit_slice({a}, start=0, width={to})"
        return to, f"{EXTEND[operation]}({a}, new_bit_count={to})"

    def comparison(self, condition, bits, a, b):
        return 1, f"{condition}({self.value(bits, a)}, {self.value(bits, b)})"

    def selection(self, condition, bits, a, b):
        cases = f"{self.value(bits, b)}, {self.value(bits, a)}"
        return bits, f"sel({self.value(1, condition)}, cases=[{cases}])"

    def place(self, pointer, bits):
        if pointer not in self.places:
            raise Refused(MEMORY)
        name, element = self.places[pointer]
        if int(bits) != self.ports[name].bits or element >= self.ports[name].count:
            raise Refused(f"takes {bits} bits out of the words of {name}")
        return name, element

    def load(self, bits, pointer):
        name, element = self.place(pointer, bits)
        if self.stored[name]:
            raise Refused(f"reads {name} after writing to it")
        return bits, f"bit_slice({name}_i, start={element * int(bits)}, width={bits})"

    def store(self, bits, value, pointer):
        name, element = self.place(pointer, bits)
        self.stored[name][element] = self.value(bits, value)

    def package(self):
        """The text of a package of XLS with this function alone."""
        words = []
        for port in self.outputs:
            missing = set(range(port.count)) - self.stored[port.name].keys()
            if missing:
                raise Refused(f"does not write word {min(missing)} of {port.name}")
            words += [self.stored[port.name][element] for element in range(port.count)]
        if not words:
            raise Refused("has no result")
        parameters = ", ".join(f"{port.name}_i: bits[{port.width}]" for port in self.inputs)
        width = sum(port.width for port in self.outputs)
        body = "".join(f"  {line}\n" for line in self.lines)
        return (f"package {self.name}\n\ntop fn {self.name}({parameters}) -> bits[{width}] {{\n"
                f"{body}  ret result: bits[{width}] = concat({', '.join(reversed(words))})\n}}\n")


def argument(text):
    found = ARGUMENT.match(text.strip())
    if not found:
        raise Refused(f"an argument must be a reference to words or arrays of words: {text}")
    count, many, one, name = found.groups()
    return Port(name, int(many or one), int(count or 1))
