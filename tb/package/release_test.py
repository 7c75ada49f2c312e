#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""release_test.py ROOT CURVECORE [TESTS ..]: one version in all places, and the files of a release,
in a tree of the places alone whose tools make nothing."""

import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, CURVECORE = pathlib.Path(sys.argv[1]), sys.argv[2]
PLACES = ("CMakeLists.txt", "CHANGELOG.md", ".github/CITATION.cff", "rtl/curvecore.core",
          "rtl/curvecore.f", "sysc/python/pyproject.toml", "scripts/version.py",
          "scripts/release.sh")
# What stands in for the tools: their files, and a line for each that was made.
TOOLS = {
    "flat": 'echo "$1" | tee "$3" >"${3%.v}.vhd"; echo "flat $1" >>build/made',
    "synth": 'mkdir -p build/synth/boards/$2; cd build/synth/boards/$2; '
             'echo {} | tee board.json >board.bit; echo "board $2" >>../../../made',
    "wheel": "mkdir -p build/wheel; touch build/wheel/a.whl build/wheel/a.tar.gz",
    "site": "mkdir -p build/site/html; touch build/site/html/index.html",
}


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name)
        for name in PLACES:
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.tree / name)

    def ask(self, command, *words, status=0):
        done = subprocess.run([self.tree / "scripts" / command, *words], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout if status == 0 else done.stderr

    def change(self, name, pattern, new):
        text, times = re.subn(pattern, new, (self.tree / name).read_text(), count=1, flags=re.M)
        self.assertEqual(times, 1, name)
        (self.tree / name).write_text(text)


class Version(Tree):
    def test_is_everywhere_the_same(self):
        done = subprocess.run([ROOT / "scripts/version.py", "--program", CURVECORE], text=True,
                              capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_another_one_is_named_with_its_file(self):
        said = self.ask("version.py", "--program", "/bin/echo", status=1)
        self.assertIn("version: /bin/echo: says '", said)
        for name, pattern, new in (
                (".github/CITATION.cff", "^version: .*", "version: 9.9.9"),
                (".github/CITATION.cff", "^date-released: 2", "date-released: 3"),
                ("rtl/curvecore.core", r"curvecore:[\d.]+\"", 'curvecore:9.9.9"'),
                ("CHANGELOG.md", r"^## \[\d.*?\]", "## [9.9.9]"),
                ("sysc/python/pyproject.toml", "VERSION", "NUMBER")):
            with self.subTest(place=new):
                before = (self.tree / name).read_text()
                self.change(name, pattern, new)
                self.assertIn(f"version: {name}: ", self.ask("version.py", status=1))
                (self.tree / name).write_text(before)

    def test_is_set_in_all_places_at_once(self):
        self.assertEqual(self.ask("version.py", "12.3.0"), "12.3.0\n")
        self.assertEqual(self.ask("version.py"), "12.3.0\n")
        self.assertRegex((self.tree / "CHANGELOG.md").read_text(),
                         r"## \[Unreleased\]\n\n## \[12\.3\.0\] - 20[\d-]{8}\n\n\S")
        for wrong in ("v13.0.0", "13.0", "12.3.0", "12.2.9"):
            self.assertIn(f"{wrong}", self.ask("version.py", wrong, status=2))
        self.assertEqual(self.ask("version.py"), "12.3.0\n")


class Release(Tree):
    def setUp(self):
        super().setUp()
        for name, text in TOOLS.items():
            file = self.tree / "scripts" / f"{name}.sh"
            file.write_text(f"#!/bin/sh\nset -e\n{text}\n")
            file.chmod(0o755)
        (self.tree / "scripts/boards").mkdir()
        for board in ("one", "two"):
            (self.tree / f"scripts/boards/{board}.json").touch()
        (self.tree / ".gitignore").write_text("/build\n")
        self.files = self.tree / "build/release_files/v12.3.0"
        self.git("init", "--quiet")
        self.commit()

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], check=True,
                       cwd=self.tree, stdout=subprocess.DEVNULL)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", "a tree")

    def prepare(self):
        self.ask("version.py", "12.3.0")
        self.commit()

    def made(self):
        return (self.tree / "build/made").read_text().splitlines()

    def test_has_all_files_with_their_sums(self):
        self.prepare()
        said = self.ask("release.sh")
        self.assertIn("git tag -a --cleanup=whitespace -F build/release_files/v12.3.0/notes.md"
                      " v12.3.0 ", said)
        sums = dict(reversed(line.split("  ")) for line in
                    (self.files / "SHA256SUMS").read_text().splitlines())
        cores = [name.removesuffix(".sv") for name in
                 (ROOT / "rtl/curvecore.f").read_text().split()
                 if "/" not in name and not name.endswith("_pkg.sv")]
        self.assertGreater(len(cores), 8)
        self.assertEqual(set(sums), {
            "notes.md", "wheel/a.whl", "wheel/a.tar.gz", "site/site.tar.gz",
            *(f"boards/{board}/{board}.{kind}" for board in ("one", "two")
              for kind in ("json", "bit")),
            *(f"verilog/{core}/{core}.{kind}" for core in cores for kind in ("v", "vhd"))})
        for name, said in sums.items():
            self.assertEqual(hashlib.sha256((self.files / name).read_bytes()).hexdigest(), said)
        notes = (self.files / "notes.md").read_text()
        self.assertIn("- ", notes)
        self.assertNotIn("\n## ", notes)

    def test_goes_on_where_it_was_stopped(self):
        self.prepare()
        (self.tree / "build").mkdir()
        (self.tree / "build/two").touch()
        self.change("scripts/synth.sh", "^set -e", r"set -e; [ $2 != two ] || [ ! -e build/two ]")
        self.commit()
        said = self.ask("release.sh", status=1)
        self.assertIn("boards/two cannot be made", said)
        self.assertFalse((self.files / "SHA256SUMS").exists())
        before = self.made()
        (self.tree / "build/two").unlink()
        self.ask("release.sh")
        self.assertEqual(self.made(), before + ["board two"])
        self.ask("release.sh")
        self.assertEqual(self.made(), before + ["board two"])
        (self.tree / "ABOUT").touch()
        self.commit()  # another commit: everything anew
        self.ask("release.sh", "--without", "bitstreams,site")
        self.assertEqual(self.made(), before + ["board two"]
                         + [line for line in before if line.startswith("flat ")])
        self.assertFalse((self.files / "boards").exists())

    def test_refuses_what_is_no_release(self):
        def refused(reason, *words):
            self.assertIn(reason, self.ask("release.sh", *words, status=2))
            self.assertFalse((self.tree / "build/release_files").exists())

        self.change("CHANGELOG.md", r"^## \[Unreleased\]\n", "## [Unreleased]\n\n- a: b.\n")
        self.commit()
        refused("what stands under [Unreleased] is not in ")
        self.prepare()
        refused("'all' is not known", "all")
        refused("'boards' is no part: one of verilog bitstreams wheel site", "--without", "boards")
        (self.tree / "rtl/new.sv").touch()
        refused("changes that are in no commit: commit them, or put them aside (git stash)\n"
                "?? rtl/new.sv")
        self.commit()
        self.git("tag", "v12.3.0")
        (self.tree / "ABOUT").touch()
        self.commit()
        refused("v12.3.0 is another commit")
        self.change("CHANGELOG.md", r"^## \[12.3.0\]", "## [12.4.0]")
        self.commit()
        refused("CHANGELOG.md: the newest section is of version 12.4.0")
        shutil.rmtree(self.tree / ".git")
        refused("is no clone")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
