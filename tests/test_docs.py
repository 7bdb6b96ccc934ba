"""The documentation as a site: everything has its page, no link is lost, searches in both languages find it."""

from __future__ import annotations

import json
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import click
import pytest
from support.browser import without
from support.gallery import ALL, ROOT

import graphic_tmm
from graphic_tmm.__main__ import main as command_line
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.sections import declared

DOCS = ROOT / ".docs"
NEEDED = ("mkdocs", "material", "mkdocstrings", "pypandoc")

pytestmark = pytest.mark.slow


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


def test_the_page_of_a_chapter_has_theory_and_a_worked_example(site: Path) -> None:
    for one in chapters():
        for home in (site, site / "ru"):
            text = (home / "theory" / f"{one.name}.html").read_text(encoding="utf-8")
            assert 'id="worked"' in text
            assert "<svg" in text.partition('id="worked"')[2] or not one.board, one.name
        english = (site / "theory" / f"{one.name}.html").read_text(encoding="utf-8")
        assert "Sources:" in english


def test_searches_find_pages_in_both_languages(site: Path) -> None:
    assert "theory/forces.html" in found(site, "Zhukovsky lever", "en")
    assert "commands/accuracy.html" in found(site, "--budget", "en") | found(
        site, "errors work", "en"
    )
    assert "python/Drawn.html" in found(site, "protocol of a plan", "en")
    assert "theory/kinematics.html" in found(site, "план скоростей", "ru")
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


def test_the_site_is_published_as_it_is_built_here() -> None:
    workflow = (ROOT / ".github" / "workflows" / "docs.yml").read_text(encoding="utf-8")
    assert "python .docs/build.py" in workflow
    assert "--no-examples" not in workflow
    assert ".ci/lock.txt" in workflow
