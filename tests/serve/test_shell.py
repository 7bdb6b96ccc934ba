"""The pages of the studio and their files: what they carry is escaped, complete, and theirs alone."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from importlib.resources import files
from pathlib import Path

import pytest

from graphic_tmm.language.catalogue import languages
from graphic_tmm.serve.shell import FILES, SHARED, WORDS, asset, assets, gallery, studio, title_of

WEB = files("graphic_tmm.serve") / "web"
HOSTILE = "</script><script>alert(1)</script><img src=x onerror='alert(1)'>&amp;\"'"


class Read(HTMLParser):
    """The elements of a page, and the texts that stand in each."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[tuple[str, str]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        if data.strip():
            self.texts.append((self.elements[-1][0], data))

    def data(self) -> dict[str, object]:
        (found,) = (text for tag, text in self.texts if tag == "script")
        return json.loads(found)  # type: ignore[no-any-return]


def page(name: str = "windrower", title: str = "A title", language: str = "en") -> str:
    return studio(
        name, title, language, formats=["svg", "xyz"], several=True, fixed=False, photographed=True
    )


@pytest.mark.parametrize("language", languages())
def test_a_page_has_its_words_and_its_language(language: str) -> None:
    for text in (page(language=language), gallery({"a": "A"}, "folder", language)):
        read = Read(text)
        assert ("html", {"lang": language}) in read.elements
        words = read.data()["words"]
        assert isinstance(words, dict)
        assert words.keys() == WORDS.keys()


def test_whatever_a_scene_is_called_stays_a_text() -> None:
    plain = Read(page()).elements
    for text in (page(HOSTILE, HOSTILE), page(title=HOSTILE), page(HOSTILE, "")):
        assert Read(text).elements == plain
    read = Read(gallery({HOSTILE: HOSTILE, "b": ""}, HOSTILE, "en"))
    assert [tag for tag, _ in read.elements].count("script") == 2
    assert read.data()["scenes"] == [
        {"name": HOSTILE, "title": HOSTILE},
        {"name": "b", "title": "b"},
    ]
    assert dict(read.texts)["h1"] == HOSTILE


def test_downloads_are_named_and_unknown_ones_by_their_format() -> None:
    assert Read(page()).data()["downloads"] == [
        {"form": "svg", "name": FILES["svg"]},
        {"form": "xyz", "name": "XYZ"},
    ]


def test_everything_that_is_asked_for_is_there() -> None:
    for text, count in ((page(), 5), (gallery({}, "folder", "en"), 4)):
        asked = re.findall(r'(?:href|src)="[./]*web/([^"]+)"', text)
        assert len(asked) == count
        for name in (*asked, *assets()):
            found = asset(name)
            assert found is not None
            imported = re.findall(r'^import .*"\./([\w.-]+)";$', found[0].decode(), re.M)
            assert set(imported) <= assets()
            assert "page/web" not in re.sub(r"import\(.*?\)", "", found[0].decode())


OTHERS = [
    "",
    ".",
    "..",
    "../shell.py",
    "..%2fshell.py",
    "shell.py",
    "studio",
    "/etc/passwd",
    "main.js",
]
ODD = ["studio.js/", "types.js\0", "../web/studio.js", "templates/shell.html", "STUDIO.JS"]


@pytest.mark.parametrize("name", [*OTHERS, *ODD])
def test_nothing_else_is_given_out(name: str) -> None:
    assert asset(name) is None


def test_words_and_scripts_know_each_other() -> None:
    texts = [(asset(name) or (b"", ""))[0].decode() for name in sorted(assets())]
    asked = {word for text in texts for word in re.findall(r'words\["([^"]+)"\]', text)}
    assert asked <= WORDS.keys()
    whole = "".join(texts)
    named = {
        word for word in WORDS if f'"{word}"' in whole or re.search(rf"^ +{word}: ", whole, re.M)
    }
    assert WORDS.keys() - named == {"no scripts"}


def test_what_is_shared_is_the_page_s_own() -> None:
    own = {one.name for one in WEB.iterdir()}
    assert own & set(SHARED) == set()


@pytest.mark.parametrize(
    ("data", "title"),
    [
        (b'title = "Press"', "Press"),
        (b"title = 3", ""),
        (b"title = ", ""),
        (b"\xff", ""),
        (b"", ""),
        (b'title = "' + b"a" * 500 + b'"', "a" * 200),
    ],
)
def test_the_title_of_a_scene(data: bytes, title: str) -> None:
    assert title_of(data, Path("scene.toml")) == title
