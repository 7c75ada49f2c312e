# SPDX-License-Identifier: Apache-2.0
"""Expectations of a host on bench_registers.sv, from registers.json."""

import json
import os
import random

AXES = 3
# Words that registers.json leaves to the build: constants that the bench does not set.
ZERO = {"CAPABILITY", "CORE", "CLOCK", "WIDTHS", "STATE", "AXES", "ROOM", "SAMPLES", "PATH_LO",
        "PATH_HI", "RATE", "STEPS", "OUTPUTS"}
REFUSED = {"PROFILE_HI", "SAMPLE", "REFERENCE"}  # by the motion beside them


class Registers:
    """Words by address; access() returns the expected result of an access."""

    def __init__(self):
        with open(os.environ["REGISTERS_JSON"], encoding="ascii") as file:
            description = json.load(file)
        self.words = {}
        for register in description["registers"]:
            for axis in range(AXES if register["axis"] else 1):
                address = register["address"] + axis * description["axes"]["stride"]
                self.words[address] = dict(register, value=sum(
                    field["reset"] << field["low"] for field in register["fields"]))
        version = self.words[4]
        version["value"] |= int(os.environ["WORDS_VERSION"]) << version["fields"][1]["low"]

    def access(self, write, address, data):
        """Returns (error, word read)."""
        word = self.words.get(address)
        if word is None or not word["write" if write else "read"]:
            return True, None
        if write:
            if word["name"] in REFUSED:
                return True, None
            if word["read"] and word["name"] not in ZERO:
                word["value"] = data
            return False, None
        return False, 0 if word["name"] in ZERO else word["value"]


    def accesses(self, number, seed=1):
        """Returns a random (write, address, data); three of four addresses are registers'."""
        chance = random.Random(seed)
        known = list(self.words)
        # Values that PATH_HI and RATE keep.
        yield False, next(at for at in known if self.words[at]["name"] == "PATH_LO"), 0
        for n in range(1, number):
            address = chance.choice(known) if n % 4 else 4 * chance.randrange(128)
            yield (chance.random() < 0.5, address,
                   chance.getrandbits(32) >> chance.randrange(32))
