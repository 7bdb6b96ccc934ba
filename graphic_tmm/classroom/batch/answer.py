"""What is done where the work is done: a parcel comes in, an answer goes back, whatever happens in between."""

from __future__ import annotations

import os
import pickle
import traceback
from collections.abc import Mapping
from threading import Lock
from typing import Any, NamedTuple

from graphic_tmm.classroom.batch.digest import package
from graphic_tmm.classroom.batch.work import Work, done
from graphic_tmm.errors import TRACEBACK, TmmError, own_fault
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.reader import reading
from graphic_tmm.language.said import said

_ALONE = Lock()
"""A process draws one thing at a time, however many threads give it work."""


class Answer(NamedTuple):
    """What came of a piece of work: its files and what is told of it; or why there is none.

    ``refused``: what a person can put right; ``fault``: what nobody has foreseen.
    """

    files: Mapping[str, bytes] = {}
    told: tuple[str, ...] = ()
    refused: str = ""
    fault: str = ""


def parcel(work: Work, language: str) -> bytes:
    """Return a piece of work as it travels; ``language``: that of its messages.

    Raises
    ------
    Exception
        Of pickle's, if it cannot travel.
    """
    return pickle.dumps((package(), language, work), pickle.HIGHEST_PROTOCOL)


def answer(sent: bytes) -> Answer:
    """Do a piece of work that was sent, and return what came of it; nothing is raised."""
    with _ALONE:
        try:
            there, language, work = pickle.loads(sent)
        except Exception as error:
            return Answer(fault=_fault(error))
        with reading(language):
            speech = speaking(language)
            if there != package():
                says = said(
                    "graphic-tmm is {here} where the work is done, and {there} here: install one version",
                    here=package(),
                    there=there,
                )
                return Answer(refused=speech(says))
            try:
                return _answered(work)
            except TmmError as error:
                return Answer(refused=error.told(speech))
            except MemoryError:
                return Answer(fault=speech(said("there is too little memory for this")))
            except Exception as error:
                return Answer(fault=speech(_fault(error)))


def _answered(work: Work) -> Answer:
    found: Any = done(work)
    files = {
        str(name): text.encode("utf-8") if isinstance(text, str) else bytes(text)
        for name, text in found.files.items()
    }
    return Answer(files, tuple(map(str, found.told)))


def _fault(error: Exception) -> str:
    if os.environ.get(TRACEBACK):
        traceback.print_exception(error)
    return own_fault(error)
