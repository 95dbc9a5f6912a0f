"""Lays out the documents as MkDocs takes them, from what the project has anyway: `python documents.py TARGET`.

The documents of `docs/`, the notebooks as they ran, a page for each quantity from the formula book and the generated
code, the command line from its own help, the Python interface from its docstrings. Formulas are typeset here, so that
no page needs a script for them.
"""

from __future__ import annotations

import posixpath
import re
import shutil
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import yaml
from book_sections import bibliography, introduction, sections
from command_line import command_line
from long_formulas import long_formula
from notebook_pages import notebook_page
from quantity_pages import chapters, quantity_page
from typeset_math import typeset

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parents[1] / "documents"
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
NOT_A_PAGE = {"formulas.md"}  # the whole formula book: each quantity has a page of its own
GUIDES = ("conversions", "checking", "finding", "testing", "model_of_your_own", "tracks", "motion", "finite_sample",
          "line_and_fusion", "simulation", "verification")  # fmt: skip
EXPLANATIONS = ("one_idea", "proved", "rounding", "way_of_a_formula", "reproduction", "benchmarks")
BEFORE = ("tutorial", *GUIDES, *EXPLANATIONS)
PUBLIC = ("convert", "observe", "kalman", "initiate", "fixed_gain", "finite_sample_filter", "line", "variance_table",
          "fusion", "simulate", "consistency", "validity", "testing")  # fmt: skip
SCOREBOARD = "scoreboard.html"  # a page of its own look
LINK = re.compile(
    r"(?<!!)\[(?P<words>(?:[^\[\]]|\[[^\]]*\])*)\]"
    r"\((?!https?:|mailto:)(?P<target>[^)#\s]*)(?P<anchor>#[^)\s]*)?\)"
)
TITLE = re.compile(r"^# (.+)$", re.MULTILINE)

Pages = dict[str, str]


def main(target: Path) -> None:
    """Write `mkdocs.yml`, the same with a choice of releases, and the pages."""
    pages = {**_documents(), **_notebooks(), **_quantities(), **_reference()}
    names = {one.name.replace(".", ""): one.name for one in sections()}
    pages = {place: _linked(text, place, pages, names) for place, text in pages.items()}
    pages = dict(zip(pages, typeset(list(pages.values())), strict=True))
    folder = target / "docs"
    for place, text in pages.items():
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        (folder / place).write_text(text, encoding="utf-8")
    (folder / SCOREBOARD).write_text(_scoreboard(), encoding="utf-8")
    for pictures in (ROOT / "docs" / "pictures", HERE / "static"):
        shutil.copytree(pictures, folder / pictures.name, dirs_exist_ok=True)
    look = (ROOT / "radartrack" / "_reports" / "look.css").read_text(encoding="utf-8")
    extra = (HERE / "documents.css").read_text(encoding="utf-8")
    (folder / "documents.css").write_text(_of_formulas(look) + extra, encoding="utf-8")
    settings = yaml.safe_load((HERE / "mkdocs.yml").read_text(encoding="utf-8"))
    settings |= {"nav": _navigation(pages), "docs_dir": str(folder), "copyright": f"radartrack {VERSION}"}
    settings["plugins"][1]["mkdocstrings"]["handlers"]["python"]["paths"] = [str(ROOT)]
    (target / "mkdocs.yml").write_text(yaml.safe_dump(settings, sort_keys=False), encoding="utf-8")
    released = {"INHERIT": "mkdocs.yml", "extra": {"version": {"provider": "mike", "default": "latest"}}}
    (target / "release.yml").write_text(yaml.safe_dump(released), encoding="utf-8")


def _documents() -> Pages:
    pages = {"index.md": (HERE / "index.md").read_text(encoding="utf-8")}
    for path in sorted((ROOT / "docs").rglob("*.md")):
        place = path.relative_to(ROOT / "docs").as_posix()
        if place not in NOT_A_PAGE:
            pages[place] = path.read_text(encoding="utf-8")
    for name in ("CHANGELOG", "CONTRIBUTING"):
        pages[f"{name.lower()}.md"] = (ROOT / f"{name}.md").read_text(encoding="utf-8")
    return pages


def _notebooks() -> Pages:
    return {f"notebooks/{path.stem}.md": notebook_page(path) for path in sorted((ROOT / "notebooks").glob("*.ipynb"))}


def _quantities() -> Pages:
    found = sections()
    pages = {
        f"quantities/{one.name}.md": quantity_page(one, "" if one.latex else long_formula(one.name)) for one in found
    }
    text = [f"# Quantities\n\n{introduction()}\n"]
    for module, names in chapters(found):
        text += [f"\n## {module}\n", *(f"- [{name}]({name}.md): {meaning}" for name, meaning in names)]
    pages["quantities/index.md"] = "\n".join(text)
    pages["quantities/sources.md"] = f"# Sources\n\n{bibliography()}\n"
    return pages


def _reference() -> Pages:
    pages = {f"python/{name}.md": f"# radartrack.{name}\n\n::: radartrack.{name}\n" for name in PUBLIC}
    return pages | {"command_line.md": command_line()}


def _scoreboard() -> str:
    """The audit of literature and libraries, with a way back, and findings where the site has them."""
    page = (ROOT / "docs" / SCOREBOARD).read_text(encoding="utf-8")
    page = re.sub(r'href="findings/(\w+)\.md"', r'href="findings/\1/"', page)
    return page.replace("<body>\n", '<body>\n<p><a href="./">radartrack</a></p>\n', 1)


def _linked(text: str, place: str, pages: Pages, names: dict[str, str]) -> str:
    """Links between files of the project as links between pages; what is no page is only named."""
    origin = "" if place in {"changelog.md", "contributing.md", "index.md"} else f"docs/{place}"
    if place.startswith("notebooks/"):
        origin = place
    if place.startswith(("quantities/", "python/")) or place in {"index.md", "command_line.md"}:
        return text

    def link(found: re.Match[str]) -> str:
        words, target, anchor = found["words"], found["target"], found["anchor"] or ""
        if not target:
            return found[0]
        path = posixpath.normpath(posixpath.join(posixpath.dirname(origin), target))
        page = _page_of(path, anchor, pages, names)
        if page is None:
            return words
        kept = "" if page.startswith("quantities/") else anchor
        return f"[{words}]({posixpath.relpath(page, posixpath.dirname(place) or '.')}{kept})"

    return LINK.sub(link, text)


def _page_of(path: str, anchor: str, pages: Pages, names: dict[str, str]) -> str | None:
    """The page of a file of the project."""
    if path == "docs/formulas.md":
        name = names.get(anchor.removeprefix("#"))
        return f"quantities/{name}.md" if name else "quantities/index.md"
    if path == f"docs/{SCOREBOARD}":
        return SCOREBOARD
    known = {
        "README.md": "index.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md",
        "notebooks": "notebooks/choose_a_conversion.md", "docs": "index.md",
        "docs/decisions": "decisions/0001-stable-forms.md",
    }  # fmt: skip
    page = known.get(path) or path.removeprefix("docs/").replace(".ipynb", ".md")
    return page if page in pages else None


def _navigation(pages: Pages) -> list[object]:
    title = {place: _title(text) for place, text in pages.items()}

    def entries(places: Iterator[str] | list[str]) -> list[object]:
        return [{title[place]: place} for place in places if place in pages]

    others = sorted(place for place in pages if "/" not in place and place.removesuffix(".md") not in
                    {"index", "changelog", "contributing", "command_line", *BEFORE})  # fmt: skip
    by_module = [
        {module: [{name: f"quantities/{name}.md"} for name, _ in names]} for module, names in chapters(sections())
    ]
    return [
        {"Check a formula": "check/"},
        {"Tutorial": "tutorial.md"},
        {"Guides": entries([*(f"{name}.md" for name in GUIDES), *others])},
        {"Quantities": ["quantities/index.md", *by_module, {"Sources": "quantities/sources.md"}]},
        {"Reference": [{"Command line": "command_line.md"}, *({f"radartrack.{n}": f"python/{n}.md"} for n in PUBLIC)]},
        {"Explanation": [
            *entries([f"{name}.md" for name in EXPLANATIONS]),
            {"Decisions": entries(sorted(place for place in pages if place.startswith("decisions/")))},
        ]},
        {"Audits": [
            {"Scoreboard": SCOREBOARD},
            {"Findings": entries(sorted(place for place in pages if place.startswith("findings/")))},
        ]},
        {"Notebooks": entries(sorted(place for place in pages if place.startswith("notebooks/")))},
        {"Changes": ["changelog.md", "contributing.md"]},
    ]  # fmt: skip


def _title(text: str) -> str:
    found = TITLE.search(text)
    return re.sub(r"[`*]", "", found[1]) if found else "?"


def _of_formulas(look: str) -> str:
    """The part of the common look that is about formulas."""
    return "".join(line + "\n" for line in look.splitlines() if line.startswith((".array", ".tml-", "math[")))


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
