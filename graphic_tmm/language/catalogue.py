"""The languages that the package speaks: English, of which it is written, and one catalogue for each other.

To add a language, put its catalogue beside this file, called by the language's code: ``de.po``. It is then a
language of scenes, of the option ``--language`` and of terminals; what it has no text for is said in English.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from gettext import c2py
from pathlib import Path
from typing import Any

from graphic_tmm.language.po import Key, read
from graphic_tmm.language.said import Said

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
        """Whether the catalogue has a text of its own for this one."""
        return (context, text) in self._texts


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
    found = read(file)
    return Speech(language, found.texts, c2py(found.plurals))
