"""A dwell as drawn: the plan of positions of the six-bar stands while it should; a dyad that does not close."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from support.boards import in_usual_size, recorded
from support.examples import most

from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.linkage_synthesis.findings import WARNINGS
from graphic_tmm.chapters.linkage_synthesis.plan import SYNTHESIS_PLAN
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Row, Side
from graphic_tmm.mechanism.synthesis import lengths_found
from graphic_tmm.mechanism.synthesis_dwell import best_arc, point_of, range_of
from graphic_tmm.scene.length_task import Task
from graphic_tmm.scene.read import read

CASES = most(20)

DWELL = """title = "T"
language = "en"
[task]
kind = "dwell"
OA = 0.04
AB = 0.11
BC = 0.11
OC = 0.13
M = [0.095, 0.075]
dwell = [120, 200]
tolerance = 0.0003
E = [0.11, 0.02]
[synthesis]
[[sheet]]
format = "A3"
"""


def random_task(rng: np.random.Generator) -> Task:
    start = float(rng.uniform(0, 360))
    return Task(
        "dwell", OA=float(rng.uniform(0.02, 0.05)), AB=0.12, BC=0.11, OC=0.13, tolerance=1.0,
        dwell=(start, start + float(rng.uniform(30, 140))),
        M=complex(*rng.uniform(-0.15, 0.15, 2)), E=complex(*rng.uniform(-0.15, 0.15, 2)),
    )  # fmt: skip


def six_bar(task: Task, lengths: Mapping[str, float], sense: int) -> Mechanism:
    assert task.M is not None
    assert task.E is not None
    coupler = {"A": 0j, "B": complex(lengths["AB"]), "M": task.M}
    return Mechanism(
        Link(0, {"O": 0j, "C": complex(lengths["OC"]), "E": task.E}),
        (
            Link(1, {"O": 0j, "A": complex(lengths["OA"])}),
            Link(2, coupler, side=Side(1, ("A", "C"))),
            Link(3, {"B": complex(lengths["BC"]), "C": 0j}),
            Link(4, {"M": 0j, "D": complex(lengths["MD"])}, side=Side(sense, ("M", "E"))),
            Link(5, {"D": complex(lengths["DE"]), "E": 0j}),
        ),
        Drive(1, 1.0),
    )


def test_the_plan_of_a_dwell_stands_while_it_should() -> None:
    rng, done = np.random.default_rng(8), 0
    while done < CASES:
        task = random_task(rng)
        try:
            found = lengths_found("dwell", task.given)
        except StructureError:
            continue
        start, sweep = range_of(task.given)
        point, arc = point_of(task.given), best_arc(point_of(task.given), start, sweep)
        turns = start + sweep * np.linspace(0.0, 1.0, 31)
        assert task.E is not None
        # the pin D goes about E by what the path leaves the arc, more where MD is nearly along DE
        arms, lever = point.at(turns) - arc.centre, task.E - arc.centre
        across = np.abs((arms * np.conj(lever)).imag / np.abs(arms) / abs(lever))
        if arc.off > 0.02 * min(found["MD"], found["DE"]) or across.min() < 0.35:
            continue
        done += 1
        sense = (
            1
            if ((arc.centre - point.at(turns)[0]) / (task.E - point.at(turns)[0])).imag > 0
            else -1
        )
        project = recorded(
            six_bar(task, found, sense),
            Row(31, 1, places=tuple(turns.tolist())),
            plans=["positions"],
        )
        plans = KINEMATICS_PLAN.on(project)
        mark = plans.positions.point("D")
        reading = execute(project.construction, project.given | {plans.mu_l: 1.0}, [mark])
        away = np.abs(np.ravel(reading[mark]) - arc.centre)
        assert away.max() <= 1.3 * arc.off / across.min()
        assert away.max() >= 0.5 * arc.off  # as told, not by far less


def test_a_dyad_that_does_not_close_is_told(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(DWELL, encoding="utf-8")
    (board,) = in_usual_size(read(path), exact=True).boards
    made = SYNTHESIS_PLAN.on(board)
    assert made.dyad is not None
    away = np.abs(board.reading[made.dyad.course][0] - board.reading[made.pivots[-1]][0, 0])
    arm, lever = (board.value(mark) for mark in made.dyad.links)
    due = [str(15 * k) for k in range(24) if not abs(arm - lever) <= away[k] <= arm + lever]
    assert due
    (line,) = WARNINGS.warnings(board, "en")
    assert line.endswith(
        f"crank at {', '.join(due)}° the links MD and DE do not reach each other: move E"
    )
