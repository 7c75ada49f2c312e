#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the pages of the site and MkDocs' configuration from what the tree holds; nothing is typed
twice: headers of RTL, registers, tables of curves, pages of the tree, the program's answers.

    make_docs.py --program build/curvecore --wasm build/site/wasm --build build/site
"""

import argparse
import json
import pathlib
import re
import shutil

from curve_pages import curve_pages
from register_page import register_page
from rtl_pages import core_page, modules_page
from tree import ROOT, Docs

HERE = pathlib.Path(__file__).resolve().parent
MARKDOWN = ["tables", "attr_list", "md_in_html", "sane_lists",
            {"toc": {"permalink": True}}, "pymdownx.superfences",
            {"pymdownx.highlight": {"use_pygments": True}}]


def guide_page(docs, page, guide):
    text = [f"# {guide['title']}", guide["text"]]
    for heading, source, section in guide["parts"]:
        body = docs.include(page, source, section)
        body = re.sub(r"^(#{2,5}) ", r"#\1 ", body, flags=re.M)
        text += [f"## {heading}", body,
                 docs.linked(f"From [{source}]({source}).", "", page)]
    if "source" in guide:
        heading, source = guide["source"]
        text += [f"## {heading}", f"```\n{(ROOT / source).read_text().rstrip()}\n```"]
    docs.write(page, "\n\n".join(part for part in text if part))
    return page


def demo_page(docs, wasm):
    """The page of the demo: its markup, and the program as WebAssembly in a file of JavaScript."""
    page = "demo.md"
    names = ["demo.ngc", "splines.ngc", "arcs.ngc", "helix.ngc", "lines.ngc", "nurbs.ngc"]
    programs = {name: (ROOT / "tb/data" / name).read_text() for name in names}
    docs.write(page, (HERE / "demo/demo.html").read_text())
    target = docs.out / "demo"
    target.mkdir(parents=True, exist_ok=True)
    for script in ("page.js", "drawing.js"):
        shutil.copyfile(HERE / "demo" / script, target / script)
    worker = (wasm / "curvecore.js").read_text() + (HERE / "demo/worker.js").read_text()
    (target / "curvecore.js").write_text(
        f"const WORKER = {json.dumps(worker)};\nconst PROGRAMS = {json.dumps(programs)};\n")
    return page


def tree_pages(docs):
    """Pages of the tree: front page, rooms, results, and what belongs to the project."""
    pages = [file for file in sorted(docs.files) if file.endswith(".md")
             and not file.startswith(".github/ISSUE")]
    return [docs.copy(file) for file in pages]


def navigation(pages):
    def title(page):
        return page.rsplit("/", 1)[-1].removesuffix(".md").replace("_", " ")

    rooms = [page for page in pages["tree"] if page.endswith("README.md") and "/" in page]
    results = [page for page in pages["tree"] if page.startswith("scripts/results/")]
    project = [page for page in pages["tree"] if page.startswith("project/")]
    return [{"Home": "README.md"}, {"Demo": "demo.md"},
            {"Guides": [{page["title"]: name} for name, page in pages["guides"].items()
                        if name.startswith("guides/")]},
            {"Cores": [*pages["cores"], {"Registers": "registers.md"},
                       {"Modules": [{title(page): page} for page in pages["modules"]]}]},
            {"Curves": [{"Curves as tables": "ref/curves/README.md"},
                        *[{title(page): page} for page in pages["curves"]]]},
            {"Papers": "papers.md"},
            {"Results": [{title(page): page} for page in results]},
            {"Rooms": [{page.removesuffix("/README.md"): page} for page in rooms
                       if page != "ref/curves/README.md"]},
            {"Project": [*project, "CHANGELOG.md"]}]


def configuration(nav):
    """MkDocs' file; JSON is YAML, too."""
    palette = [{"media": f"(prefers-color-scheme: {of})", "scheme": scheme, "primary": "custom",
                "accent": "custom",
                "toggle": {"icon": f"material/brightness-{icon}", "name": f"Show it {other}"}}
               for of, scheme, icon, other in (("light", "default", 7, "dark"),
                                               ("dark", "slate", 4, "light"))]
    return {"site_name": "curvecore", "docs_dir": "docs", "site_dir": "html",
            "use_directory_urls": False, "plugins": [], "nav": nav,
            "extra_css": ["site.css"], "markdown_extensions": MARKDOWN,
            "theme": {"name": "material", "font": False, "palette": palette,
                      "features": ["navigation.tabs", "navigation.top", "toc.follow",
                                   "content.code.copy"],
                      "icon": {"logo": "material/vector-curve"}},
            "validation": {"nav": {"omitted_files": "ignore"},
                           "links": {"anchors": "warn", "unrecognized_links": "warn"}}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--wasm", type=pathlib.Path, required=True, help="folder of curvecore.js")
    parser.add_argument("--build", type=pathlib.Path, required=True)
    asked = parser.parse_args()
    out = asked.build / "docs"
    shutil.rmtree(out, ignore_errors=True)
    docs = Docs(out)
    guides = json.loads((HERE / "guides.json").read_text())
    for page, guide in guides.items():
        guide_page(docs, page, guide)
    cores = [core_page(docs, path) for path in sorted(docs.files)
             if re.fullmatch(r"rtl/\w+\.sv", path) and not path.endswith("_pkg.sv")]
    folders = sorted({path.split("/")[1] for path in docs.files
                      if re.fullmatch(r"rtl/\w+/\w+\.sv", path)} - {"examples"})
    modules = [modules_page(docs, folder) for folder in folders]
    register_page(docs)
    curves = curve_pages(docs, asked.program.resolve(),
                         json.loads((HERE / "curves.json").read_text()))
    demo_page(docs, asked.wasm)
    tree = tree_pages(docs)
    shutil.copyfile(HERE / "site.css", out / "site.css")
    docs.write_sources()
    nav = navigation({"guides": guides, "cores": cores, "modules": modules, "curves": curves,
                      "tree": tree})
    (asked.build / "mkdocs.yml").write_text(json.dumps(configuration(nav), indent=1))


if __name__ == "__main__":
    main()
