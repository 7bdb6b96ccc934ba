"""Do a list of works once each, and write what comes of them: what is there already is not made again.

::

    works --record--> those that are missing --rounds--> answers --> files, record of each

Who made the files of a folder is written beside them, work by work, after they are whole; so a run that was
broken off, however, goes on where it was. What takes its process with it is done again alone, in the end.
The ledger knows what is done, and what is still to do in which round.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.classroom.batch.executors import died
from graphic_tmm.classroom.batch.record import (
    Record,
    clear,
    digest_of,
    is_safe,
    locked,
    lost,
    read_record,
    write_files,
    write_record,
)
from graphic_tmm.classroom.batch.rounds import TooLongError, answers, hearing
from graphic_tmm.classroom.batch.work import Answer, Work, digest
from graphic_tmm.errors import SheetError, own_fault, printable
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said

Tell = Callable[[int, int, str], None]
"""Called with how many works are done, of how many, and the name of the last."""


class Ran(NamedTuple):
    """What came of a run, all in the order of its works.

    ``made``, ``kept``: names of works that were made, and that were there; ``failed``: messages by name;
    ``told``: lines that are told of a work, by its name. ``of``: how many works there are.
    """

    made: tuple[str, ...]
    kept: tuple[str, ...]
    failed: Mapping[str, str]
    told: Mapping[str, tuple[str, ...]]
    of: int

    @property
    def done(self) -> int:
        """How many works are there now."""
        return len(self.made) + len(self.kept)


class Ledger:
    """What of a run is done, and what is still to do."""

    def __init__(self, works: Sequence[Work], out: Path, tell: Tell, limit: float = 0.0) -> None:
        self._works, self._out, self._tell, self._limit = works, out, tell, limit
        self._made: set[str] = set()
        self._kept: set[str] = set()
        self._failed: dict[str, str] = {}
        self._told: dict[str, tuple[str, ...]] = {}
        self._again: list[Work] = []
        self._alone: list[Work] = []
        self._round = 0

    def rounds(self) -> Iterator[tuple[bool, Iterator[Work]]]:
        """Yield the works of each round, and whether each is done alone.

        First those that are missing; then what has met an error, once more; then, one at a time, what was on
        its way when a process died; and once more what dies alone: it may not have been begun before. What came
        to its limit alone is not tried again.
        """
        yield False, self._missing()
        self._round = 1
        again, self._again = self._again, []
        if again:
            yield False, iter(again)
        for self._round in (2, 3):
            alone, self._alone = self._alone, []
            if alone:
                yield True, iter(alone)

    def _missing(self) -> Iterator[Work]:
        for work in self._works:
            record = read_record(self._out, work.name)
            if record is None or record.made_of != digest(work):
                yield work
            elif changed := lost(self._out, record):
                there = [name for name in changed if (self._out / name).exists()]
                self._say(work, [_made_anew(name) for name in there])
                yield work
            else:
                self._kept.add(work.name)
                self._say(work, record.told)
                self._ended(work)

    def take(self, work: Work, found: Answer | BaseException) -> None:
        """Write what came of a work, or put it off to another round, or give it up."""
        if isinstance(found, TooLongError):
            self._put_off(work, [], False, reader()(_too_long(self._limit)))
        elif not isinstance(found, Answer):
            self._put_off(work, self._alone, self._round < 3, _lost(found))
        elif found.refused:
            self._put_off(work, [], False, found.refused)
        elif found.fault:
            self._put_off(work, self._again, self._round < 1, found.fault)
        elif bad := [name for name in found.files if not is_safe(name)]:
            says = said("{name}: this is no name for a file", name=repr(bad[0]))
            self._put_off(work, [], False, reader()(says))
        else:
            self._keep(work, found)

    def _put_off(self, work: Work, until: list[Work], more: bool, message: str) -> None:
        if more:
            until.append(work)
        else:
            self._failed[work.name] = message
            self._ended(work)

    def _keep(self, work: Work, found: Answer) -> None:
        digests = {name: digest_of(data) for name, data in found.files.items()}
        old = read_record(self._out, work.name)
        write_files(self._out, found.files)
        if old is not None:
            self._say(work, map(_left, clear(self._out, old.files, digests)))
        self._say(work, found.told)
        write_record(self._out, Record(work.name, digest(work), digests, found.told))
        self._made.add(work.name)
        self._ended(work)

    def _say(self, work: Work, lines: Iterable[str]) -> None:
        told = tuple(lines)
        if told:
            self._told[work.name] = self._told.get(work.name, ()) + told

    def _ended(self, work: Work) -> None:
        count = len(self._made) + len(self._kept) + len(self._failed)
        self._tell(count, len(self._works), work.name)

    def ran(self) -> Ran:
        """Return what has come of the run until now."""
        names = [work.name for work in self._works]
        return Ran(
            tuple(name for name in names if name in self._made),
            tuple(name for name in names if name in self._kept),
            {name: self._failed[name] for name in names if name in self._failed},
            {name: self._told[name] for name in names if name in self._told},
            len(names),
        )


def _lost(error: BaseException) -> str:
    """Return what is told of a work that brought no answer."""
    if died(error):
        return reader()(said("the process that made it died: killed, or out of memory"))
    return reader()(own_fault(error))


def _too_long(limit: float) -> str:
    lasts = said("{n:g} min", n=limit / 60) if limit >= 60 else said("{n:g} s", n=limit)
    return said(
        "it took longer than {limit} and was broken off; if it needs more, give it more with --limit",
        limit=lasts,
    )


def _made_anew(name: str) -> str:
    says = said("{file} was not as it had been made: it is made anew", file=printable(name))
    return reader()(says)


def _left(name: str) -> str:
    says = said("{file} is made no more, but was changed: it is left", file=printable(name))
    return reader()(says)


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
