"""The page as a file: the same bytes each time, no way past its policy, text of a scene is text everywhere."""

from __future__ import annotations

import base64
import hashlib
import re
import subprocess
import sys
from collections import Counter
from html.parser import HTMLParser
from importlib.resources import files
from pathlib import Path

import pytest
from support import pages
from support.each import each
from support.gallery import ROOT, SHEETS

from graphic_tmm.errors import SheetError
from graphic_tmm.page import page
from graphic_tmm.page.page import modules_of, program_parts, script, style

WEB = files("graphic_tmm.page") / "web"
TYPES = "export {};"
"""What a module of nothing but types says is no code."""
FURTHER = sorted(one.name for one in WEB.iterdir() if one.is_dir())


@pytest.mark.parametrize("further", [(), tuple(FURTHER)])
def test_every_line_of_code_is_carried(further):
    code: Counter[str] = Counter()
    for text in modules_of(*further).values():
        code.update(
            line.lstrip().removeprefix("export ")
            for line in text.splitlines()
            if line and line != TYPES and not line.startswith("import ") and not _comment(line)
        )
    # what is written down of a scene alone asks for the arithmetic of rows
    written = 'import { ROWS } from "../live/rows.js";\n' if further else ""
    joined = Counter(
        line.removeprefix("export ")
        for line in script(*further, written=written).splitlines()
        if line
    )
    assert joined == code


def test_no_text_goes_over_a_line():
    for text in modules_of(*FURTHER).values():
        for line in text.splitlines():
            assert line.count("`") % 2 == 0, line


def test_no_comment_is_carried():
    assert not [line for line in script(*FURTHER).splitlines() if _comment(line)]


@pytest.fixture
def web(tmp_path, monkeypatch):
    """A page of one module, with a folder that enters a way of looking and a module that nobody imports."""

    def written(name: str, *lines: str) -> None:
        file = tmp_path / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")

    written("main.js", 'import { ROOMS } from "./rooms.js";', "begin(ROOMS);")
    written("rooms.js", "export const ROOMS = {};")
    written("page.css", "p { margin: 0; }")
    written(
        "more/enter.js",
        'import { ROOMS } from "../rooms.js";',
        'import { made } from "./made.js";',
        "ROOMS.more = made;",
    )
    written("more/made.js", 'import "./told.js";', "export const made = 1;")
    written("more/told.js", "tell();")
    written("more/more.css", "p { padding: 0; }")
    monkeypatch.setattr(page, "_WEB", tmp_path)
    for kept in (program_parts, style):
        monkeypatch.setattr(page, kept.__name__, kept.__wrapped__)
    return written


def test_a_page_has_only_what_it_was_asked_for(web):
    assert page.script() == "\nconst ROOMS = {};\nbegin(ROOMS);\n"
    assert "padding" not in page.style()


def test_a_folder_is_entered_before_the_page_begins(web):
    lines = page.script("more").splitlines()
    assert lines.index("tell();") < lines.index("ROOMS.more = made;") < lines.index("begin(ROOMS);")
    text = page.style("more")
    assert text.index("margin:0") < text.index("padding:0")


def test_one_name_stands_once_in_all_folders(web):
    web("more/told.js", "const ROOMS = 1;")
    with pytest.raises(SheetError, match=r"ROOMS stands in (rooms|more/told)\.js and in"):
        page.script("more")


def test_the_real_folders_are_told_by_no_page_that_does_not_ask():
    inside = {name for name in modules_of(*FURTHER) if "/" in name}
    assert all(Path(name).parts[0] in FURTHER for name in inside)
    assert len(script()) <= len(script(*FURTHER))


def _comment(line: str) -> bool:
    bare = line.strip()
    cast = bare.startswith("/**") and "*/ " in bare
    return not cast and (bare.startswith(("/**", "* ", "*/", "//")) or bare == "*")


NAMES = ("crank-rocker", "planetary", "lettering")
"""A mechanism, a part, neither."""
FORBIDDEN = (
    "innerHTML",
    "outerHTML",
    "insertAdjacentHTML",
    "srcdoc",
    "eval(",
    "new Function",
    "document.write",
    "import(",
    "fetch(",
    "XMLHttpRequest",
    'http-equiv="refresh"',
)
NAMESPACE = re.compile(r'xmlns(:\w+)?="[^"]*"|"http://www.w3.org/2000/svg"')


class Reader(HTMLParser):
    """What a browser is told: elements with attributes, text of scripts, of styles, of the title."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str]]] = []
        self.held: dict[str, list[str]] = {"script": [], "style": []}
        self.inside = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, {name: value or "" for name, value in attrs}))
        self.inside = tag
        if tag in self.held:
            self.held[tag].append("")

    def handle_endtag(self, tag: str) -> None:
        self.inside = ""

    def handle_data(self, data: str) -> None:
        if self.inside in self.held:
            self.held[self.inside][-1] += data


def hashed(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def policy(read: Reader) -> dict[str, list[str]]:
    """The page's policy by its directives."""
    (told,) = (
        attributes["content"]
        for tag, attributes in read.elements
        if attributes.get("http-equiv") == "Content-Security-Policy"
    )
    return {first: rest for first, *rest in (one.split() for one in told.split(";"))}


@each("name", NAMES)
def test_a_page_allows_its_own_program_and_style_and_nothing_else(name: str) -> None:
    read = Reader(pages.text(name, pages.language(name)))
    allowed = policy(read)
    assert allowed["default-src"] == ["'none'"]
    assert allowed["require-trusted-types-for"] == ["'script'"]
    assert allowed["trusted-types"] == ["'none'"]
    programs = [
        text
        for (_, attributes), text in zip(
            [one for one in read.elements if one[0] == "script"], read.held["script"], strict=True
        )
        if attributes.get("type", "") in ("", "module", "text/javascript")
    ]
    assert set(allowed["script-src"]) == set(map(hashed, programs))
    assert set(allowed["style-src"]) == set(map(hashed, read.held["style"]))
    known = {"default-src", "script-src", "style-src", "require-trusted-types-for", "trusted-types"}
    others = {name: rest for name, rest in allowed.items() if name not in known}
    assert set(map(tuple, others.values())) <= {("'none'",)}, others


@each("name", NAMES)
def test_a_page_asks_for_nothing_and_runs_nothing_from_text(name: str) -> None:
    text = pages.text(name, pages.language(name))
    assert [word for word in FORBIDDEN if word in text] == []
    for tag, attributes in Reader(text).elements:
        assert "style" not in attributes, tag
        assert not [name for name in attributes if name.startswith("on")], tag
        assert not {"src", "href", "xlink:href", "action", "srcset"} & attributes.keys() or (
            attributes.get("href", "").startswith("#")
        ), tag
    assert re.findall(r"\w+://[^\s\"'<>)]+", NAMESPACE.sub("", text)) == []


@pytest.mark.slow
def test_a_page_is_the_same_bytes_whatever_the_day_the_order_of_hashes_or_the_locale(
    tmp_path: Path,
) -> None:
    """In a process of its own, far away, as in this one."""
    command = [sys.executable, "-m", "graphic_tmm", "page", str(SHEETS / "crank-rocker")]
    env = {"PYTHONHASHSEED": "77", "TZ": "Asia/Tokyo", "LC_ALL": "POSIX", "PYTHONPATH": str(ROOT)}
    subprocess.run([*command, "-o", str(tmp_path / "out")], check=True, cwd=ROOT, env=env)
    (file,) = (tmp_path / "out").iterdir()
    assert file.read_bytes() == pages.text("crank-rocker", "en").encode()
