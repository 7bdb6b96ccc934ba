"""What a frame of the page costs while a length is changed: the log at every angle, and the ink that follows.

`python tests/benchmarks/live_ink.py [SCENE ...]` runs the page's program in node without a browser: the medians
of one run, ms, and the ink's part of all of it.
"""

from __future__ import annotations

import sys

from clock import Row, show
from support.gallery import paper
from support.scripts import run

from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.page.crank import crank
from graphic_tmm.page.live.givens import live_log
from graphic_tmm.page.practice.pack import written_module

SCENES = ("crank-rocker", "windrower")
WANTED = 8.0
"""A frame of script may cost so much, ms."""
CHANGES = 60
PROGRAM = """
import "./practice/written.js";
import { LiveInk } from "./live/liveink.js";
import { LiveRun } from "./live/run.js";
const run = new LiveRun(asked.data, asked.whole);
const ink = new LiveInk(asked.ties, asked.whole, run.frames, (k) => run.marks(k), (k) => run.few(k));
const { pin, paths, breaks } = asked.data;
run.kept = [...pin, ...paths, ...breaks.map(([slot]) => slot), ...ink.expressions.turning];
const spent = { log: [], turn: [], ink: [], charts: [] };
const [slots, own] = asked.length;
for (let n = 0; n < asked.changes; n++) {
  const begun = performance.now();
  run.give(new Map(slots.map((slot) => [slot, own * (1 + 0.001 * n)])));
  for (const _ of ink.positions());
  const ran = performance.now();
  ink.given(true);
  ink.at(n);
  for (const own of asked.variants) ink.expressions.drawn(own);
  const followed = performance.now();
  ink.given(true);
  ink.turned = ink.version;
  ink.at(n + 1);
  for (const own of asked.variants) ink.expressions.drawn(own);
  const turned = performance.now();
  run.charts();
  spent.charts.push(performance.now() - turned);
  spent.log.push(ran - begun);
  spent.turn.push(followed - ran);
  spent.ink.push(turned - followed);
}
const middle = (row) => row.slice(row.length / 3).sort((a, b) => a - b)[Math.floor(row.length / 3)];
tell(Object.fromEntries(Object.entries(spent).map(([name, row]) => [name, middle(row)])));
"""


def measured(name: str) -> dict[str, float]:
    """Return what a frame costs, ms: the log at every angle, the ink then, ink only turned, diagrams."""
    made, sheets = paper(name)
    turned = crank(made, sheets, live=True)
    assert turned is not None
    board = RowScript()
    data, logs = live_log(turned.found, turned.slots, turned.charted, board, made.scene.language)
    figures = turned.data["figures"]
    moved = [one for figure in figures for one in (*figure["lines"], *figure["letters"])]
    length = next(one for one in data["sliders"] if one["l"].startswith("l"))
    asked = {
        "data": data,
        "whole": turned.found.whole,
        "ties": turned.data["ties"],
        "variants": [one[-1] for one in moved if len(one) > 4 and one[-1]],
        "length": [length["slots"], length["v"]],
        "changes": CHANGES,
    }
    spent: dict[str, float] = run(PROGRAM, asked, written=written_module(board, {}, logs))
    return spent


def main() -> None:
    """Measure the scenes that are named, or those that are usual."""
    rows = []
    for name in sys.argv[1:] or SCENES:
        spent = measured(name)
        whole = spent["log"] + spent["turn"]
        told = f"{whole:.1f} ms, of it ink {100 * spent['turn'] / whole:.0f} %"
        rows.append(Row(f"{name}: a length", told, f"{WANTED:g} ms", whole <= WANTED))
        for what, ms in (("an angle", spent["ink"]), ("its diagrams", spent["charts"])):
            rows.append(Row(f"{name}: {what}", f"{ms:.2f} ms", f"{WANTED:g} ms", ms <= WANTED))
    show("a frame of script", rows)


if __name__ == "__main__":
    main()
