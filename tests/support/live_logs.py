"""The log of a mechanism as its page runs it, run by node with other givens."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark
from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.board.values import Number
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.page.practice.pack import written_module
from support import gallery
from support.scripts import run

CASES = 5
"""So often givens are changed of each scene."""
SHARE = 0.04
"""They are changed by so much at most."""
NEAR = 1e-9
"""Numbers are alike to this share of the largest of their kind in their view."""
DUST = 1e-6
"""What is smaller than this share of the largest of its kind is what sums that cancel leave."""
Floats = NDArray[np.float64]

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


ACROSS = """
import "./practice/written.js";
import { LiveRun } from "./live/run.js";
const live = new LiveRun(asked.data, asked.whole);
const parts = (value) => Object.values(value).flatMap(numbers);
const numbers = (value) => (typeof value === "object" ? parts(value) : [Number(value)]);
const plain = (value) => numbers(value).map((x) => (Number.isFinite(x) ? x : null));
tell(asked.cases.map((changed) => {
  live.give(new Map(changed));
  return live.charts().map((marks) => marks.map(plain));
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
    script = RowScript()
    log = LiveLog(found, script)
    return LivePage(found, log, written_module(script, {}, log.functions))


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


def across_by_page(page: LivePage, cases: Sequence[Mapping[Mark, float]]) -> list[list[list[Any]]]:
    """Return the numbers of all marks by their slots, in each case in each position of the sheet."""
    asked = {
        "data": page.log.data(),
        "whole": page.found.whole,
        "cases": [[[m.slot, v] for m, v in one.items()] for one in cases],
    }
    found: list[list[list[Any]]] = run(ACROSS, asked, written=page.written)
    return found


def turning() -> list[str]:
    """Return the scenes of the package whose mechanism turns."""
    return [name for name in gallery.ALL if gallery.scene(name).mechanism is not None]


def changed(page: LivePage, n: int) -> dict[Mark, float]:
    """Return quantities that are given, each changed by another share; alike letters alike."""
    return {
        mark: float(np.ravel(value)[0])
        * (1.0 + SHARE * (2.0 * crc32(f"{mark.name} {n}".encode()) / 2**32 - 1.0))
        for mark, value in page.log.own.items()
        if mark.kind is Number and mark.unit and np.size(value) == 1
    }


def largest(numbers: Floats) -> float:
    """Return the largest of numbers, 0 where there is none."""
    return float(np.nanmax(np.abs(numbers), initial=0.0))
