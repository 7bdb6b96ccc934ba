"""The log of a mechanism as its page runs it, run by node with other givens."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.board.script import Script
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.page.practice.pack import HEAD
from support.scripts import run

PROGRAM = """
import "./practice/written.js";
import { LiveRun } from "./live/run.js";
const live = new LiveRun(asked.data, asked.whole);
const numbers = (value) => (typeof value === "object" ? Object.values(value).flatMap(numbers) : [value]);
const plain = (value) => numbers(value).map((x) => (Number.isFinite(x) ? x : null));
tell(asked.cases.map(({ changed, at }) => {
  live.give(new Map(changed));
  return at.map((k) => live.marks(k).map(plain));
}));
"""


class LivePage(NamedTuple):
    """A mechanism at every angle, its log for the page, and that written down."""

    found: Dense
    log: LiveLog
    written: str


def live_page(drawn: Drawn) -> LivePage | None:
    """Return what a page runs of a mechanism; None where nothing turns."""
    found = dense(drawn)
    if found is None:
        return None
    script = Script()
    log = LiveLog(found, script)
    return LivePage(found, log, HEAD + script.program({}, "enterBoard", log.logs))


def by_page(
    page: LivePage, cases: Sequence[Mapping[Mark, float]], at: Sequence[int]
) -> list[list[list[Any]]]:
    """Return the numbers of all marks by their slots, in each case at each of some angles (indices)."""
    asked = {
        "data": page.log.data(),
        "whole": page.found.whole,
        "cases": [{"changed": [[m.slot, v] for m, v in one.items()], "at": at} for one in cases],
    }
    found: list[list[list[Any]]] = run(PROGRAM, asked, written=page.written)
    return found
