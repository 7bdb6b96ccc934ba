"""Tables of texts: a name that code computes, the English text, and so the text in any language."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.language.catalogue import Speech, languages, speaking


class Words(Mapping[str, str]):
    """A table of English texts, read in a language."""

    def __init__(self, table: Mapping[str, str], speech: Speech) -> None:
        self._table, self._speech = table, speech

    def __getitem__(self, name: str) -> str:
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
