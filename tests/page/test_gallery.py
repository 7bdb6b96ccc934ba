"""A gallery of pages: every scene of a folder, links that resolve, two languages, the same bytes each time."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import pytest
from support.command import invoke
from support.served import SMALL

from graphic_tmm.errors import SheetError
from graphic_tmm.page.gallery import Card, galleries

CARDS = (
    Card("cam", "Кулачок", "ru", "cam.html", "cam.svg"),
    Card("a b", '<b>"A" & B</b>', "en", "a b.html", "a b-1.svg"),
    Card("третий", "Третий", "ru-u-ms-metric", "третий.html", "третий.svg"),
)


class Read(HTMLParser):
    """The addresses of a page, the languages of its parts, what stands in it as text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.leads: list[str] = []
        self.tags: list[str] = []
        self.text = ""
        self.language = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.tags.append(tag)
        self.leads += [unquote(given[key] or "") for key in ("href", "src") if key in given]
        if tag == "html":
            self.language = given["lang"] or ""

    def handle_data(self, data: str) -> None:
        self.text += data


def test_a_gallery_leads_to_every_scene_and_to_itself_in_other_languages() -> None:
    found = {name: Read(str(text)) for name, text in galleries(CARDS, "Folder").items()}
    assert {name: one.language for name, one in found.items()} == {
        "index.html": "ru",
        "index.en.html": "en",
    }
    for name, one in found.items():
        due = {file for card in CARDS for file in (card.page, card.picture)}
        assert set(one.leads) == due | (found.keys() - {name})
        assert all(card.title in one.text for card in CARDS)
        assert {"b", "script"} & set(one.tags) == set()
    assert galleries(CARDS, "Folder", "en").keys() == {"index.html", "index.ru.html"}


def test_a_policy_forbids_all_but_the_pictures_and_the_style() -> None:
    text = str(galleries(CARDS, "Folder")["index.html"])
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', text)
    assert policy.startswith("default-src 'none'; img-src 'self' file:; style-src 'sha256-")
    assert " style=" not in text
    assert "http" not in text.replace("http-equiv", "")


@pytest.mark.parametrize("name", ["index", "Index.ru"])
def test_no_scene_takes_the_place_of_the_gallery(name: str) -> None:
    with pytest.raises(SheetError, match="rename this scene"):
        galleries([Card(name, "", "en", f"{name}.html", "a.svg")], "Folder")


@pytest.mark.slow
def test_all_scenes_of_a_folder_are_written_with_a_gallery(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    for name, title in (("a b", "First"), ("второй", "Second")):
        (folder / name).mkdir(parents=True)
        text = SMALL.replace('"Small"', f'"{title}"')
        (folder / name / "scene.toml").write_text(text, encoding="utf-8")
    written = []
    for home in (tmp_path / "one", tmp_path / "two"):
        done = invoke("page", folder, "--all", "-o", home)
        assert done.exit_code == 0, done.output
        assert sorted(done.stdout.split("\n")[:-1]) == sorted(map(str, home.iterdir()))
        written.append({file.name: file.read_bytes() for file in home.iterdir()})
    assert written[0] == written[1]
    names = {"a b.html", "a b.svg", "второй.html", "второй.svg", "index.html", "index.ru.html"}
    assert written[0].keys() == names
    for name in ("index.html", "index.ru.html"):
        one = Read(written[0][name].decode())
        assert set(one.leads) == names - {name}
        assert ("mine" in one.text, "Second" in one.text) == (True, True)


@pytest.mark.slow
def test_a_folder_without_scenes_and_a_scene_with_a_fault_write_nothing(tmp_path: Path) -> None:
    bare, home = tmp_path / "bare", tmp_path / "out"
    bare.mkdir()
    done = invoke("page", bare, "--all", "-o", home, "-l", "en")
    assert (done.exit_code, "no scene stands there" in done.stderr) == (2, True)
    (bare / "fine.toml").write_text(SMALL)
    (bare / "wrong.toml").write_text(SMALL.replace("positions = 2", "positions = -2"))
    done = invoke("page", bare, "--all", "-o", home)
    assert (done.exit_code, "wrong.toml" in done.stderr, home.exists()) == (2, True, False)
