"""The languages that the package speaks: English, of which it is written, and one catalogue for each other.

To add a language, put its catalogue beside this file, called by the language's code: ``de.po``. It is then a
language of scenes, of the option ``--language`` and of terminals; what it has no text for is said in English.

Of a catalogue only what it holds is read: context, text, its plural, the translations. Babel reads the same and
more, and takes five times as long to be imported as this takes for the whole catalogue; the tests hold one
against the other.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from gettext import c2py
from pathlib import Path
from typing import Any, NamedTuple

from graphic_tmm.language.said import Said

Key = tuple[str, str]
"""Context ("" if none) and English text."""


class Catalogue(NamedTuple):
    """``texts``: the translations of each text, one for each plural form; ``plurals``: the header's rule."""

    texts: Mapping[Key, tuple[str, ...]]
    plurals: str


def read_catalogue(path: Path) -> Catalogue:
    """Return the catalogue in a file; what is marked as fuzzy or not translated is left out."""
    texts: dict[Key, tuple[str, ...]] = {}
    plurals = "n != 1"
    for entry in _entries(path.read_text(encoding="utf-8")):
        told = tuple(text for field, text in entry.items() if field.startswith("msgstr"))
        if not entry["msgid"]:
            _, _, rule = told[0].partition("plural=")
            plurals = rule.partition(";")[0] or plurals
        elif all(told):
            texts[entry.get("msgctxt", ""), entry["msgid"]] = told
    return Catalogue(texts, plurals)


def _entries(text: str) -> Iterator[dict[str, str]]:
    """Yield the fields of every entry, an empty line behind each."""
    entry: dict[str, str] = {}
    field, fuzzy = "", False
    for line in (*text.splitlines(), ""):
        if not line:
            if entry and not fuzzy:
                yield entry
            entry, fuzzy = {}, False
        elif line.startswith("#"):
            fuzzy = fuzzy or (line.startswith("#,") and "fuzzy" in line)
        elif line.startswith('"'):
            entry[field] += _plain(line)
        else:
            field, _, quoted = line.partition(" ")
            entry[field] = _plain(quoted)


def _plain(quoted: str) -> str:
    return json.loads(quoted) if "\\" in quoted else quoted[1:-1]


FOLDER = Path(__file__).parent
"""Where the catalogues are."""
SOURCE = "en"
"""The language that the package is written in."""


class Speech:
    """A language as a function: the text in it, with values put in.

    Called with a text of the package, or with one that was `said` before; a text that is neither (a letter, a
    title) comes back as it is.
    """

    def __init__(
        self,
        language: str,
        texts: Mapping[Key, tuple[str, ...]] | None = None,
        form: Callable[[int], int] = lambda n: int(n != 1),
    ) -> None:
        self.language, self._texts, self._form = language, texts or {}, form

    def __call__(self, text: str, plural: str = "", /, *, context: str = "", **values: Any) -> str:
        """Return a text in this language; ``plural``, ``context`` and values as in `said.said`."""
        if isinstance(text, Said):
            known = text
            text, plural, context = known.template, known.plural, known.context
            values = {**known.values, **values}
        told = self._texts.get((context, text)) or ((text, plural) if plural else (text,))
        form = self._form(int(values["n"])) if plural else 0
        if not values:
            return told[form]
        return told[form].format(**{key: self._put(value) for key, value in values.items()})

    def _put(self, value: Any) -> Any:
        if isinstance(value, float) and (sign := self(".", context="decimal sign")) != ".":
            return _Figure(value, sign)
        return self(value) if isinstance(value, Said) else value

    def knows(self, text: str, context: str = "") -> bool:
        """Whether the catalogue has a text of its own for this one, or for the template it was made of."""
        key = (text.context, text.template) if isinstance(text, Said) else (context, text)
        return key in self._texts


class _Figure:
    """A number in a sentence that says how many digits it has: the language's decimal sign stands in it."""

    def __init__(self, value: float, sign: str) -> None:
        self.value, self.sign = value, sign

    def __format__(self, wanted: str) -> str:
        told = format(self.value, wanted)
        return told.replace(".", self.sign) if wanted else told


def languages() -> tuple[str, ...]:
    """Return the codes of all languages, English first."""
    return _languages(FOLDER)


@cache
def _languages(folder: Path) -> tuple[str, ...]:
    found = {path.stem for path in folder.glob("*.po")}
    return (SOURCE, *sorted(found - {SOURCE}))


def speaking(language: str) -> Speech:
    """Return a language, its catalogue read once; English for a language that has none.

    What follows the code says in which units (BCP 47: ``en-u-ms-ussystem``), and nothing of the words.
    """
    return _spoken(FOLDER, code_of(language))


def code_of(language: str) -> str:
    """Return the code of a language without what its tag says of units: ``ru`` of ``ru-u-ms-ussystem``."""
    return language.partition("-")[0]


@cache
def _spoken(folder: Path, language: str) -> Speech:
    file = folder / f"{language}.po"
    if not file.exists():
        return Speech(language)
    found = read_catalogue(file)
    return Speech(language, found.texts, c2py(found.plurals))


class Words(Mapping[str, str]):
    """A table of English texts, read in a language; ``more``: what is called by names that it does not have."""

    def __init__(
        self,
        table: Mapping[str, str],
        speech: Speech,
        more: Callable[[str, Speech], str] = lambda name, speech: "",
    ) -> None:
        self._table, self._speech, self._more = table, speech, more

    def __getitem__(self, name: str) -> str:
        if name not in self._table and (told := self._more(name, self._speech)):
            return told
        return self._speech(self._table[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)


class Tongues(Mapping[str, Words]):
    """A table of English texts in every language, by the language's code."""

    def __init__(self, table: Mapping[str, str]) -> None:
        self._table = table

    def __getitem__(self, language: str) -> Words:
        return Words(self._table, speaking(language))

    def __iter__(self) -> Iterator[str]:
        return iter(languages())

    def __len__(self) -> int:
        return len(languages())
