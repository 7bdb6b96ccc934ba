"""What is done where the work is done: a parcel comes in, an answer goes back, whatever happens in between."""

from __future__ import annotations

import faulthandler
import os
import pickle
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from threading import Lock
from typing import Any, NamedTuple

from graphic_tmm.classroom.batch.digest import package
from graphic_tmm.classroom.batch.work import Work, brought, done
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
    """Return a piece of work as it travels, with what it brings; ``language``: that of its messages.

    Raises
    ------
    SheetError
        If a file that it brings is another now.
    Exception
        Of pickle's, if it cannot travel.
    """
    whole = (package(), language, work, brought(work))
    return pickle.dumps(whole, pickle.HIGHEST_PROTOCOL)


def answer(sent: bytes, limit: float = 0.0) -> Answer:
    """Do a piece of work that was sent, and return what came of it; nothing is raised.

    ``limit``: after so many s its process ends (0: never).
    """
    with _ALONE, ending_after(limit):
        try:
            there, language, work, files = pickle.loads(sent)
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
                return _answered(work, files)
            except TmmError as error:
                return Answer(refused=error.told(speech))
            except MemoryError:
                return Answer(fault=speech(said("there is too little memory for this")))
            except Exception as error:
                return Answer(fault=speech(_fault(error)))


@contextmanager
def ending_after(limit: float) -> Iterator[None]:
    """End this process at once if what is done within takes longer, s (0: however long it takes).

    Python's own watchman does it: a thread that needs nothing of Python and so is not kept waiting by a loop in
    machine code, on every system and in whichever thread the work is done, as no alarm of a signal is. Where it
    was is told if faults are to show that.
    """
    if not limit:
        yield
        return
    with open(os.devnull, "wb") as nowhere:
        told = 2 if os.environ.get(TRACEBACK) else nowhere
        faulthandler.dump_traceback_later(limit, exit=True, file=told)
        try:
            yield
        finally:
            faulthandler.cancel_dump_traceback_later()


def _answered(work: Work, brought: Mapping[str, bytes]) -> Answer:
    found: Any = done(work, brought)
    files = {
        str(name): text.encode("utf-8") if isinstance(text, str) else bytes(text)
        for name, text in found.files.items()
    }
    return Answer(files, tuple(map(str, found.told)))


def _fault(error: Exception) -> str:
    if os.environ.get(TRACEBACK):
        traceback.print_exception(error)
    return own_fault(error)
