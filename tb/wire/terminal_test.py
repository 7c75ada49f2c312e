# SPDX-License-Identifier: Apache-2.0
"""`stream` on a terminal: what it shows there, and its keys."""

import fcntl
import os
import pathlib
import pty
import re
import socket
import struct
import subprocess
import sys
import tempfile
import termios
import unittest

from wire_parts import CURVECORE, ENABLED, STATE, Board, read

COLUMNS = 60
# Some minutes of the board's time: it ends when it is told to.
PART = "G64 P0.01\n" + "".join(
    f"G1 X{100 * (n % 2 == 0)} Y{n} F600\n" for n in range(20)) + "M2\n"


class TerminalTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        self.part = folder / "part.ngc"
        self.part.write_text(PART, encoding="ascii")
        build = "engine" if "engine" in self.id() else "parallel"
        self.board = Board(str(folder / "board"), "--build", build)
        self.addCleanup(self.board.kill)
        self.terminal, inside = pty.openpty()
        self.addCleanup(os.close, self.terminal)
        fcntl.ioctl(inside, termios.TIOCSWINSZ, struct.pack("HHHH", 24, COLUMNS, 0, 0))
        self.host = subprocess.Popen(
            [CURVECORE, "stream", self.part, "--to", f"udp:127.0.0.1:{self.board.port}"],
            stdin=inside, stdout=inside, stderr=inside)
        self.addCleanup(self.host.kill)
        os.close(inside)
        self.seen = ""

    def until(self, pattern):
        """Reads until the lines that stand match; ctest ends what never is."""
        while True:
            self.seen += os.read(self.terminal, 4096).decode("ascii")
            standing = self.seen.rpartition("\033[J")[2]
            found = re.search(pattern, standing.replace("\r\n", "\n"))
            if found:
                return found

    def key(self, key):
        os.write(self.terminal, key.encode("ascii"))

    def test_shows_the_machine_and_obeys_keys(self):
        self.until(r"X +\d+\.\d{3}  Y +\d+\.\d{3}  Z +0\.000  mm\n"
                   r"feed \d+ mm/min  override 100 %  time 100 %  line \d+\n"
                   r"\d+\.\d{3} of \d+\.\d{3} mm.* left\n"
                   r"segments \d+ of \d+  profile \d+ of \d+  words.*\n"
                   r"runs\nh hold .*\n")
        self.key("h")
        held = self.until(r"(\d+\.\d{3}) of .* mm(.|\n)*\nheld\n")
        self.key("r")
        self.until(r"time 100 %(.|\n)*\nruns\n")
        self.key("--")
        self.until(r"override 80 %  time 80 % ")
        self.key("+")
        self.until(r"override 90 %  time 90 % ")
        self.key("s")
        stopped = self.until(r"stopped (\d+\.\d{3}) of \d+\.\d{3} mm planned so far, (?:.|\n)*"
                             r"\nthe same command with --from (\d+\.\d{6})mm draws the rest\n")
        self.assertGreater(float(stopped[1]), float(held[1]))
        self.assertAlmostEqual(float(stopped[1]), float(stopped[2]), delta=6e-4)
        self.assertEqual(self.host.wait(), 130)
        # No line is broken, and nothing of the panel stands at the end.
        text = re.sub(r"\033\[\d*[AJ]", "", self.seen)
        self.assertLessEqual(max(map(len, re.split(r"[\r\n]+", text.partition("stopped")[0]))),
                             COLUMNS)
        self.assertNotIn("hold", self.seen.rpartition("\033[J")[2])

    def test_shows_what_waits_at_the_entry_of_an_engine(self):
        self.until(r"\nruns\n")
        self.key("h")
        # The entry is empty: behind it the queue has room for all segments of this program.
        self.until(r"segments 0 of 128  profile \d+ of 128 (.|\n)*\nheld\n")
        self.key("s")
        self.assertEqual(self.host.wait(), 130)

    def test_a_page_that_cannot_be_turns_nothing_on(self):
        self.key("s")  # of the program that setUp began
        self.host.wait()
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            for web, why in (("70000", "must be a port"), ("here:80", "must be a port"),
                             ("127.0.0.1:x", "must be a port"), (str(port), "in use")):
                with self.subTest(web=web):
                    ended = subprocess.run(
                        [CURVECORE, "stream", self.part, "--web", web, "--to",
                         f"udp:127.0.0.1:{self.board.port}"],
                        stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
                    self.assertEqual(ended.returncode, 2, ended.stderr)
                    self.assertIn(why, ended.stderr)
                    self.assertFalse(read(self.board.port, STATE) & ENABLED)

    def test_turns_the_drives_off(self):
        self.until(r"\nruns\n")
        self.key("e")
        self.until("the board stopped: ")
        self.assertEqual(self.host.wait(), 1)


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
