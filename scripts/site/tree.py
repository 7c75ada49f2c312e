# SPDX-License-Identifier: Apache-2.0
"""Pages of the tree as pages of the site: links lead where the site has what they name, be it a
page, a folder or a source."""

import os
import pathlib
import posixpath
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"(!?\[(?:[^\]\\]|\\.)*\]\()([^)\s#]*)(#[^)\s]*)?\)")
PICTURES = (".png", ".svg")
LANGUAGES = {".sv": "systemverilog", ".hpp": "cpp", ".h": "c", ".cpp": "cpp", ".c": "c",
             ".py": "python", ".sh": "bash", ".json": "json", ".yml": "yaml", ".cmake": "cmake",
             ".ini": "ini", ".comp": "c"}


def tracked():
    """All files of the tree, by their paths from its top."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True,
                            check=False)
    if listed.returncode == 0:
        return [line for line in listed.stdout.splitlines() if (ROOT / line).exists()]
    return [str(file.relative_to(ROOT)) for file in ROOT.rglob("*")
            if file.is_file() and "build" not in file.parts]


def section(page, heading=None):
    """The text of a page below a heading of it, without deeper headings' pages; None: below its
    title."""
    text = (ROOT / page).read_text()
    parts = re.split(r"^(#+) +(.*)$", re.sub(
        r"^```.*?^```", lambda m: m[0].replace("#", "\0"), text, flags=re.S | re.M), flags=re.M)
    for level, name, body in zip(parts[1::3], parts[2::3], parts[3::3]):
        if name == heading or (heading is None and level == "#"):
            return body.replace("\0", "#").strip()
    raise ValueError(f"{page} has no section {heading!r}")


def lists_apart(text):
    """Puts an empty line before each list and indents what belongs to an item by four, as Python's
    Markdown wants them."""
    out, fenced, item = [], False, False
    for line in text.split("\n"):
        bullet = re.match(r"( *)(?:[-*]|\d+\.) ", line)
        if not fenced and bullet and out and out[-1].strip() and not item:
            out.append("")
        if bullet and not fenced:
            item = True
        elif line.strip() and not line.startswith(" ") and not fenced:
            item = False
        if item and not bullet and re.match(r" {2,3}\S", line):
            line = "    " + line.lstrip()
        elif item and fenced:
            line = " " + line if line.startswith("   ") else line
        if re.match(r" *```", line):
            fenced = not fenced
        out.append(line)
    return "\n".join(out)


class Docs:
    """The folder from which MkDocs makes the site."""

    def __init__(self, out):
        self.out = out
        self.files = set(tracked())
        self.folders = {str(up) for file in self.files for up in pathlib.PurePath(file).parents}
        self.wanted = []  # sources that pages lead to
        self.written = set()

    def place(self, path):
        """The page that the site has for a file or folder of the tree; None: there is none."""
        path = path.rstrip("/")
        if path in self.folders:
            if f"{path}/README.md" in self.files:
                return self.place(f"{path}/README.md")
            return self.want(path, f"source/{path}/index.md")
        if path not in self.files:
            return None
        if path.endswith(".md"):
            return path.replace(".github/", "project/")
        if path.endswith(PICTURES):
            target = self.out / path
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / path, target)
            return path
        return self.want(path, f"source/{path.replace('.github/', 'github/')}.md")

    def want(self, path, page):
        if (path, page) not in self.wanted:
            self.wanted.append((path, page))
        return page

    def linked(self, text, base, page):
        """Text of a file in the folder `base` of the tree, for a page of the site."""
        def link(match):
            head, name, anchor = match[1], match[2], match[3] or ""
            if re.match(r"[a-z]+:", name) or not name:
                return match[0]
            place = self.place(posixpath.normpath(posixpath.join(base, name)))
            if place is None:
                raise ValueError(f"{page}: the tree has no {name}, seen from {base or 'its top'}")
            return f"{head}{posixpath.relpath(place, posixpath.dirname(page) or '.')}{anchor})"

        parts = re.split(r"(^ *```.*?^ *```)", text, flags=re.S | re.M)
        return "".join(part if n % 2 else LINK.sub(link, part) for n, part in enumerate(parts))

    def write(self, page, text):
        file = self.out / page
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text.rstrip("\n") + "\n", encoding="utf-8")
        self.written.add(page)

    def copy(self, path):
        """Writes a page of the tree as a page of the site."""
        page = self.place(path)
        text = re.sub(r"^<!-- (begin|end): .* -->\n", "", (ROOT / path).read_text(), flags=re.M)
        self.write(page, self.linked(lists_apart(text), posixpath.dirname(path), page))
        return page

    def include(self, page, source, heading=None):
        """A section of a page of the tree, for a page of the site."""
        text = re.sub(r"^<!-- (begin|end): .* -->\n", "", section(source, heading), flags=re.M)
        return self.linked(lists_apart(text), posixpath.dirname(source), page)

    def write_sources(self):
        """Writes the pages of all sources that others lead to, until none is wanted."""
        done = 0
        while done < len(self.wanted):
            path, page = self.wanted[done]
            done += 1
            if path in self.folders:
                self.write(page, self.folder_page(path, page))
                continue
            text = (ROOT / path).read_text(encoding="utf-8")
            language = LANGUAGES.get(os.path.splitext(path)[1], "text")
            self.write(page, f"# {path}\n\n````{language}\n{text.rstrip()}\n````\n")

    def folder_page(self, path, page):
        rows = sorted({file[len(path) + 1:].split("/")[0] for file in self.files
                       if file.startswith(path + "/")})
        folder = posixpath.dirname(page)
        links = [f"- [{row}]({posixpath.relpath(self.place(f'{path}/{row}'), folder)})"
                 for row in rows]
        return f"# {path}/\n\n" + "\n".join(links)
