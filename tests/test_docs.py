"""The documentation as a site: everything has its page, no link is lost, searches in both languages find it."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import click
import pytest
from support.browser import without
from support.gallery import ALL, ROOT

import graphic_tmm
from graphic_tmm import read
from graphic_tmm.__main__ import main as command_line
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.sections import declared

DOCS = ROOT / ".docs"
NEEDED = ("mkdocs", "material", "mkdocstrings", "pypandoc")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build it; what its documents show is run by the tests that hold them."""
    if missing := [name for name in NEEDED if find_spec(name) is None]:
        without(", ".join(missing), "pip install -e '.[docs]'")
    out = tmp_path_factory.mktemp("site") / "site"
    command = [sys.executable, str(DOCS / "build.py"), "--no-examples", str(out)]
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return out


def found(site: Path, words: str, language: str) -> set[str]:
    """Return the pages whose part of the index has all the words."""
    home = site if language == "en" else site / language
    index = json.loads((home / "search" / "search_index.json").read_text(encoding="utf-8"))
    assert language in index["config"]["lang"]
    return {
        one["location"].partition("#")[0]
        for one in index["docs"]
        if all(word.lower() in f"{one['title']} {one['text']}".lower() for word in words.split())
    }


@pytest.mark.slow
def test_everything_has_its_page(site: Path) -> None:
    for home in (site, site / "ru"):
        due = {
            *(f"theory/{one.name}.html" for one in chapters()),
            *(
                f"commands/{name}.html"
                for name in command_line.list_commands(click.Context(command_line))
            ),
            *(f"keys/{name}.html" for name in declared()),
            *(f"gallery/{name}.html" for name in ALL),
        }
        assert len(due) > 80
        assert {page for page in due if not (home / page).exists()} == set()
    names = {
        name for name in graphic_tmm.__all__ if not (site / "python" / f"{name}.html").exists()
    }
    assert names == set()


@pytest.mark.slow
def test_the_page_of_a_chapter_has_theory_and_a_worked_example(site: Path) -> None:
    for one in chapters():
        for home in (site, site / "ru"):
            text = (home / "theory" / f"{one.name}.html").read_text(encoding="utf-8")
            assert 'id="worked"' in text
            assert "&lt;su" not in text
            assert "<svg" in text.partition('id="worked"')[2] or not one.board, one.name
        english = (site / "theory" / f"{one.name}.html").read_text(encoding="utf-8")
        russian = (site / "ru" / "theory" / f"{one.name}.html").read_text(encoding="utf-8")
        assert "<strong>Sources:" in english
        assert "<strong>Источники:" in russian
        assert "Sources:" not in russian


WORD = re.compile("[a-zа-яё]{4,}")
FORMULA = re.compile(r"`+[^`]+`+|[^\s,;:.()а-яё]*[²³′₀-₉α-ωΔΣΦ⊥=·≥→∥][^\s,;:.()]*")


def formulas(text: str) -> set[str]:
    """Return what a paragraph has alike in all languages: names in code, and formulas but for words in them."""
    spans = set(re.findall("`+[^`]+`+", text))
    return spans | set(FORMULA.findall(WORD.sub("", re.sub("`+[^`]+`+", "", text))))


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_catalogue_of_the_site_has_all_that_it_shows_and_nothing_else(
    language: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A paragraph of theory that is changed in English lacks its Russian until that is changed, too."""
    monkeypatch.syspath_prepend(str(DOCS))
    from documents import ENGLISH, RUSSIAN  # type: ignore[import-not-found]
    from translated import catalogue, paragraphs  # type: ignore[import-not-found]

    texts = [scene.title for name in ALL if (scene := read(name)).language != language]
    due = dict[str, bool]()
    if language == "ru":
        texts += [str(import_module(one.folder).__doc__) for one in chapters()]
        for document in set(ENGLISH) & set(RUSSIAN):
            due |= paragraphs((ROOT / document).read_text(encoding="utf-8"), code=True)
    for text in texts:
        due |= paragraphs(text)
    held = catalogue(language)
    assert {one for one, needed in due.items() if needed} - set(held) == set()
    assert set(held) - set(due) == set()
    assert [one for one, told in held.items() if formulas(one) != formulas(told)] == []


def test_a_page_never_falls_back_to_english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(DOCS))
    from translated import translated

    text = "The flywheel, otherwise put:\n\n- Chords\n- Tangents"
    assert translated(text, "en") == text
    with pytest.raises(LookupError, match=r"ru\.po has no text for: The flywheel, otherwise put:"):
        translated(text, "ru")
    monkeypatch.setattr("translated.catalogue", lambda language: {"a b": "а б", "J = 1": "J = 1"})
    assert translated("a\n  b\n\n    J = 1\n- a\n  b", "ru") == "а б\n\n    J = 1\n- а б"


@pytest.mark.slow
def test_searches_find_pages_in_both_languages(site: Path) -> None:
    assert "theory/forces.html" in found(site, "Zhukovsky lever", "en")
    assert "commands/accuracy.html" in found(site, "--budget", "en") | found(
        site, "errors work", "en"
    )
    assert "python/Drawn.html" in found(site, "protocol of a plan", "en")
    assert "theory/kinematics.html" in found(site, "план скоростей", "ru")
    assert "theory/forces.html" in found(site, "жёстким рычагом", "ru")
    assert "keys/drive.html" in found(site, "положений", "ru")
    assert "commands/check.html" in found(site, "отсчёты", "ru")
    assert not found(site, "план скоростей мотыля", "ru")


def test_a_lost_link_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(DOCS))
    from reached import lost  # type: ignore[import-not-found]

    page = tmp_path / "a.html"
    page.write_text('<p id="here"><a href="#here"></a><a href="https://else.where/x"></a></p>')
    assert lost(tmp_path) == []
    page.write_text('<a href="#gone"></a><img src="b.svg"><a href="../out.html"></a>')
    assert len(lost(tmp_path)) == 3
    unread = """<script>b = '<a href="c.html">'</script><!-- <a href="d.html"> -->"""
    page.write_text(
        f"""{unread}<a title="a > b" href='e&amp;f.html'></a><SCRIPT SRC=g.js></SCRIPT>"""
    )
    assert lost(tmp_path) == ["a.html: e&f.html leads nowhere", "a.html: g.js leads nowhere"]


def test_the_site_is_published_as_it_is_built_here() -> None:
    workflow = (ROOT / ".github" / "workflows" / "docs.yml").read_text(encoding="utf-8")
    assert "python .docs/build.py" in workflow
    assert "--no-examples" not in workflow
    assert ".ci/lock.txt" in workflow
