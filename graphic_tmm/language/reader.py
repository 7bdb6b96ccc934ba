"""The language of messages: of the command line, else of the scene, else of the terminal."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar

from graphic_tmm.language.catalogue import SOURCE, Speech, languages, speaking

VARIABLES = ("LC_ALL", "LC_MESSAGES", "LANG")
"""Environment variables; the first that is set gives the terminal's language."""
_ASKED: ContextVar[str] = ContextVar("asked", default="")
_HEARD: ContextVar[str] = ContextVar("heard", default="")


@contextmanager
def reading(language: str = "") -> Iterator[None]:
    """Speak a wanted language within the block; "" for none."""
    tokens = _ASKED.set(language), _HEARD.set("")
    try:
        yield
    finally:
        _ASKED.reset(tokens[0])
        _HEARD.reset(tokens[1])


def asked_language() -> str:
    """Return the wanted language, "" if there is none."""
    return _ASKED.get()


def hear(language: str) -> None:
    """Take the language of a scene as the reader's, unless another one is wanted."""
    _HEARD.set(language)


def reader() -> Speech:
    """Return the language of who reads what is said now."""
    return speaking(_ASKED.get() or _HEARD.get() or terminal_language(os.environ))


def terminal_language(environment: Mapping[str, str]) -> str:
    """Return the language of a terminal, English if there is no catalogue for it.

    >>> terminal_language({"LANG": "ru_RU.UTF-8"}), terminal_language({"LANG": "ru_RU", "LC_ALL": "C"})
    ('ru', 'en')
    """
    told = next(filter(None, (environment.get(name) for name in VARIABLES)), "")
    language = told.partition(".")[0].partition("_")[0].lower()
    return language if language in languages() else SOURCE
