#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every link of a page leads to a file of the site and to a place in it, and no page takes anything
from the network: it may lead there by a link alone.

    check_links.py FOLDER
"""

import html.parser
import pathlib
import re
import sys
import tempfile
import urllib.parse

TAKEN = {"script": "src", "img": "src", "iframe": "src", "source": "src", "audio": "src",
         "video": "src", "object": "data", "form": "action"}
LEADING_RELATIONS = {"canonical", "next", "prev", "alternate"}


class Page(html.parser.HTMLParser):
    """Names of places in a page, links, and addresses of what it takes."""

    def __init__(self, text):
        super().__init__()
        self.names, self.links, self.taken = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.names.update(value for value in (values.get("id"), values.get("name")) if value)
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        address = values.get(TAKEN.get(tag, ""))
        if tag == "link" and not LEADING_RELATIONS & set((values.get("rel") or "").split()):
            address = values.get("href")
        if address:
            self.taken.append(address)
            self.links.append(address)
        self.taken += re.findall(r"url\(['\"]?([^'\")]+)", values.get("style") or "")


def is_elsewhere(address):
    return re.match(r"(https?:)?//", address) is not None


def faults(folder):
    """Yields what is wrong with the site in a folder."""
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in folder.rglob("*.html")}
    for file, page in pages.items():
        if file.name == "404.html":  # a server's page, whose links begin at its top
            continue
        name = file.relative_to(folder)
        yield from (f"{name}: takes {address}" for address in page.taken if is_elsewhere(address))
        for link in page.links:
            if is_elsewhere(link) or re.match(r"(mailto|data|javascript):", link):
                continue
            path, _, place = link.partition("#")
            path = urllib.parse.unquote(path.partition("?")[0])
            target = (file.parent / path).resolve() if path else file.resolve()
            if not target.is_file():
                yield f"{name}: no file {link}"
            elif place and target in pages and place not in ("__skip", *pages[target].names) \
                    and urllib.parse.unquote(place) not in pages[target].names:
                yield f"{name}: no place {link}"
    for file in folder.rglob("*.css"):
        text = file.read_text(encoding="utf-8")
        yield from (f"{file.relative_to(folder)}: takes {address}"
                    for address in re.findall(r"url\(['\"]?([^'\")]+)", text)
                    if is_elsewhere(address))


def main():
    found = sorted(set(faults(pathlib.Path(sys.argv[1]).resolve())))
    print(*found, sep="\n", end="\n" if found else "")
    # A dead link, a missing place, and what comes from elsewhere are seen.
    with tempfile.TemporaryDirectory() as folder:
        wrong = pathlib.Path(folder).resolve() / "wrong.html"
        wrong.write_text('<a href="no.html">a</a><a href="#no">b</a><script src="//c"></script>',
                         encoding="ascii")
        seen = len(list(faults(wrong.parent)))
    return bool(found) or seen != 3


if __name__ == "__main__":
    sys.exit(main())
