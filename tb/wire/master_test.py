#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hosts that `curvecore board` obeys, and frames that it does not.

    master_test.py CURVECORE [unittest's options]
"""

import os
import pathlib
import random
import socket
import sys
import tempfile
import unittest

from wire_parts import CONTROL, ENABLED, EXPECT, SEQUENCE, STATE, Board, command, numbered, read


class MasterTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def board(self, name="board"):
        board = Board(str(self.folder / name), "--fast")
        self.addCleanup(board.kill)
        return board

    def test_a_silent_master_of_idle_drives_is_let_go(self):
        # Each refused frame has a question behind it, which is always answered.
        enable = 1
        for control, right in ((0, lambda tries: 4 < tries < 16),
                               (enable, lambda tries: tries > 64)):
            board = self.board(f"control_{control}")
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as master, \
                    socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
                for end in (master, host):
                    end.connect(("127.0.0.1", board.port))
                number = read(board.port, SEQUENCE)
                for offset, write in ((0, b""), (1, command(0x8200, 1, CONTROL, control))):
                    master.send(command(0x8300, 1, EXPECT, number + offset, number + offset + 1)
                                + write + command(0x200, 1, STATE))
                    state = int.from_bytes(master.recv(100), "little")
                self.assertEqual(bool(state & ENABLED), bool(control))
                opens = numbered(board.port) + command(0x200, 2, STATE)
                tries, answer = 0, b""
                while len(answer) != 8 and tries <= 64:
                    tries += 1
                    host.send(opens)
                    host.send(command(0x200, 1, STATE))
                    answer = host.recv(100)
                self.assertTrue(right(tries), f"after {tries} tries")

    def test_random_writes_give_no_step(self):
        board = self.board()
        chance = random.Random(4)
        number = int(os.environ.get("CURVECORE_DATAGRAMS", "1000"))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
            host.settimeout(5)
            host.connect(("127.0.0.1", board.port))
            for n in range(number):
                sequence = numbered(board.port)
                data = chance.randbytes(chance.randrange(1, 200)) if n % 2 else command(
                    0x8200, 1, 4 * chance.randrange(128), chance.getrandbits(32))
                host.send(sequence + data)
        self.assertTrue(read(board.port, STATE) & 0xFFFF)
        self.assertEqual(board.end(), [])


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
