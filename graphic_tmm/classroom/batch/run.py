"""Do a list of works once each, and write what comes of them: what is there already is not made again.

::

    works --record--> those that are missing --rounds--> answers --> files, record of each

Who made the files of a folder is written beside them, work by work, after they are whole; so a run that was
broken off, however, goes on where it was. What takes its process with it is done again alone, in the end.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

from graphic_tmm.classroom.batch.ledger import Ledger, Ran, Tell
from graphic_tmm.classroom.batch.lock import locked
from graphic_tmm.classroom.batch.record import is_safe
from graphic_tmm.classroom.batch.rounds import answers
from graphic_tmm.classroom.batch.stopping import hearing
from graphic_tmm.classroom.batch.work import Work
from graphic_tmm.errors import SheetError
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said

USUAL = 600.0
"""The limit, s, of works where nobody gives them another: a hundred times what sheets, note and page take."""


class BrokenOff(KeyboardInterrupt):
    """Ctrl-C in a run: what has come of it until then, all of it whole."""

    def __init__(self, ran: Ran) -> None:
        super().__init__()
        self.ran = ran


def run(
    works: Sequence[Work],
    out: Path,
    *,
    executor: int | str = 1,
    limit: float = 0.0,
    tell: Tell = lambda done, of, name: None,
) -> Ran:
    """Do works and write their files into a folder, but those whose files are there as they would be made.

    ``executor``: in so many processes (0: in this one), or by the cluster of a scheduler's address. ``limit``:
    a work that takes longer, s, is broken off with the process that does it (0: none; nor is any here).

    Raises
    ------
    SheetError
        If two works have one name, another run writes into the folder, it cannot be written into, or no
        scheduler answers; what is done stays.
    BrokenOff
        At Ctrl-C.
    """
    _refuse_names(works)
    language = reader().language
    with locked(out), hearing() as check:
        ledger = Ledger(works, out, tell, limit)
        try:
            for alone, some in ledger.rounds():
                found = answers(executor, some, language, check, alone=alone, limit=limit)
                with closing(found):
                    for work, one in found:
                        ledger.take(work, one)
            check()
        except KeyboardInterrupt:
            raise BrokenOff(ledger.ran()) from None
        return ledger.ran()


def _refuse_names(works: Sequence[Work]) -> None:
    known: set[str] = set()
    for work in works:
        if not is_safe(work.name):
            says = said("{name}: this is no name for a file", name=repr(work.name))
            raise SheetError(says)
        if work.name.casefold() in known:
            says = said("{name} is there twice: give each a name of its own", name=work.name)
            raise SheetError(says)
        known.add(work.name.casefold())
