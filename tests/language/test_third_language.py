"""A language is one file: a made-up one is put beside the others, and sheets, tables and errors speak it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from support.messages import messages

from graphic_tmm.language import catalogue
from graphic_tmm.language.catalogue import languages, speaking

WORD = re.compile(r"(?<![{_^\\<\w])[A-Za-z]{3,}(?![\w}])")


def upside_down(text: str) -> str:
    """Return an English text in a made-up language: every word of three letters and more backwards."""
    return WORD.sub(lambda found: found[0][::-1], text)


def quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


@pytest.fixture
def third(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder of catalogues with one more, of the language called xx."""
    folder = tmp_path / "catalogues"
    folder.mkdir()
    shutil.copy(catalogue.FOLDER / "ru.po", folder)
    lines = ['msgid ""', 'msgstr "Plural-Forms: nplurals=2; plural=n != 1;\\n"', ""]
    for one in messages():
        same = one.context.startswith(("index", "unit", "standard", "decimal"))
        told = one.text if same else upside_down(one.text)
        lines += [f"msgctxt {quoted(one.context)}"] if one.context else []
        lines += [f"msgid {quoted(one.text)}"]
        if one.plural:
            lines += [f"msgid_plural {quoted(one.plural)}", f"msgstr[0] {quoted(told)}"]
            lines += [f"msgstr[1] {quoted(upside_down(one.plural))}", ""]
        else:
            lines += [f"msgstr {quoted(told)}", ""]
    (folder / "xx.po").write_text("\n".join(lines), encoding="utf-8")
    monkeypatch.setattr(catalogue, "FOLDER", folder)


@pytest.mark.usefixtures("third")
def test_it_is_one_of_the_languages() -> None:
    assert languages() == ("en", "ru", "xx")
    assert speaking("xx")("Plan of positions") == "nalP of snoitisop"
