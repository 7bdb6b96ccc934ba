"""The page as a file: the same bytes each time, no way past its policy, text of a scene is text everywhere."""

from __future__ import annotations

import base64
import hashlib
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest
from support import pages
from support.each import each
from support.gallery import ROOT, SHEETS

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
