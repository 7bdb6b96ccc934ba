"""A synthesis as drawn: the exact hand reads what is calculated, the plan of positions does what was asked."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.boards import in_usual_size, recorded, usual_part
from support.each import each
from support.examples import most
from support.gallery import scene

from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.kinematics.given import given
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.linkage_synthesis.findings import WARNINGS, defects
from graphic_tmm.chapters.linkage_synthesis.plan import DRAWN, SYNTHESIS_PLAN
from graphic_tmm.chapters.linkage_synthesis.record import CALCULATED
from graphic_tmm.chapters.linkage_synthesis.task import ASKED, SynthesisTask
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.mechanism.records import Drive, Extreme, Guide, Link, Mechanism, Row, Side, Slide
from graphic_tmm.mechanism.synthesis import KINDS, lengths_found
from graphic_tmm.mechanism.synthesis_four_bar import choose_four_bar
from graphic_tmm.project import Project
from graphic_tmm.scene.length_task import Task
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

CASES = most(30)
EXACT = 1e-9


def drawn(task: Task) -> Drawn:
    """The board of a task without a mechanism, by the exact hand."""
    return usual_part("synthesis", ASKED.put(Scene("", "T", "en", task=task), SynthesisTask()))


def row(rng: np.random.Generator, low: float, high: float) -> tuple[float, ...]:
    return tuple(rng.uniform(low, high, 3).tolist())


def random_task(kind: str, way: frozenset[str], rng: np.random.Generator) -> Task:
    """A task of a kind with random figures."""
    stroke = float(rng.uniform(0.05, 0.4))
    given: dict[str, Any] = {
        "K_v": float(rng.uniform(1.05, 1.6)), "stroke": stroke, "OB": float(rng.uniform(0.2, 0.9)),
        "v_m": float(rng.uniform(1, 5)), "n": float(rng.uniform(20, 60)),
        "e": float(rng.uniform(0.005, 0.06)), "lambda_": float(rng.uniform(2, 6)),
        "pressure": float(rng.uniform(8, 40)), "psi": float(rng.uniform(20, 60)),
        "BC": 0.1, "OC": float(rng.uniform(0.08, 0.2)), "transmission": float(rng.uniform(10, 30)),
        "A": tuple(complex(*rng.uniform(-0.1, 0.1, 2)) for _ in range(3)), "angles": row(rng, 0, 90),
        "AB": 0.08, "OA": float(rng.uniform(0.03, 0.08)),
        "crank": row(rng, 0, 180), "rocker": row(rng, 30, 120),
        "x": (1.0, 2.0), "power": float(rng.uniform(0.5, 2.5)),
    }  # fmt: skip
    if kind == "dwell":
        start = float(rng.uniform(0, 360))
        given |= {"OA": float(rng.uniform(0.02, 0.05)), "AB": 0.12, "BC": 0.11, "OC": 0.13}
        given |= {"dwell": (start, start + float(rng.uniform(30, 140))), "tolerance": 1.0}
        given |= {name: complex(*rng.uniform(-0.15, 0.15, 2)) for name in "ME"}
    if kind == "function":
        given |= {"crank": (30.0, 110.0), "rocker": (60.0, 130.0), "y": "ln x"}
        given |= {"x": (1.0, 2.0, 2.5), "values": (0.0, 1.0, 3.0)} if "values" in way else {}
    names = {name if name != "lambda" else "lambda_" for name in way}
    return Task(kind, **{name: given[name] for name in names})


@each("kind", KINDS)
def test_the_exact_hand_reads_what_is_calculated(kind: str) -> None:
    rng, done = np.random.default_rng(len(kind)), 0
    while done < CASES:
        way = KINDS[kind].ways[done % len(KINDS[kind].ways)]
        task = random_task(kind, way, rng)
        try:
            board = drawn(task)
        except StructureError:
            continue
        done += 1
        made, calculated = SYNTHESIS_PLAN.on(board), CALCULATED.on(board)
        assert made.measured
        for name, mark in made.measured.items():
            far = max(abs(complex(board.reading[p][0, 0])) for p in made.points) * board.value(
                made.mu
            )
            assert board.value(mark) == pytest.approx(
                board.value(calculated[name]), abs=EXACT * far
            )
        found = lengths_found(kind, task.given)
        assert {name for name in found if not {name, name[1:]} & set(task.given)} <= set(calculated)
        assert all(board.value(calculated[k]) == v for k, v in found.items() if k in calculated)


def test_a_locus_about_the_rockers_pivot_is_drawn() -> None:
    board = drawn(Task("crank-rocker", psi=60.0, K_v=1.4, BC=0.075, transmission=30.0))
    made, calculated = SYNTHESIS_PLAN.on(board), CALCULATED.on(board)
    for name, mark in made.measured.items():
        assert board.value(mark) == pytest.approx(board.value(calculated[name]), rel=EXACT)
    assert min(map(board.value, made.transmission)) == pytest.approx(30.0, rel=EXACT)


def test_every_kind_is_drawn() -> None:
    assert DRAWN.keys() == KINDS.keys()


def stroke_and_ratio(project: Project, letter: str) -> tuple[float, float, complex, complex]:
    """K_v by the crank's angles at the extremes of a point, and its places there, m."""
    plans = KINEMATICS_PLAN.on(project)
    mark = plans.positions.point(letter)
    reading = execute(project.construction, project.given | {plans.mu_l: 1.0}, [mark])
    places = np.ravel(reading[mark])
    first, last = (project.coordinates[k] for k in (0, -1))
    assert first is not None
    assert last is not None
    way = (last - first) % 360.0
    slow = max(way, 360.0 - way)
    return slow / (360.0 - slow), abs(places[-1] - places[0]), places[0], places[-1]


EXTREMES = Row(12, 0, Extreme("B", "left"), (Extreme("B", "right"),))


def test_the_plan_of_a_slider_crank_has_the_stroke_and_the_ratio() -> None:
    rng, done = np.random.default_rng(3), 0
    while done < CASES:
        stroke, K_v = float(rng.uniform(0.05, 0.4)), float(rng.uniform(1.03, 1.8))
        given = {"stroke": stroke, "K_v": K_v, "e": stroke * float(rng.uniform(0.05, 0.8))}
        try:
            found = lengths_found("slider-crank", given)
        except StructureError:
            continue
        done += 1
        guide = Guide("x", complex(0.0, -found["e"]), 0.0)
        mechanism = Mechanism(
            Link(0, {"O": 0j}, (guide,)),
            (
                Link(1, {"O": 0j, "A": complex(found["OA"])}),
                Link(2, {"A": 0j, "B": complex(found["AB"])}),
                Link(3, {"B": 0j}, (), (Slide(0, guide, side=Side(1)),)),
            ),
            Drive(1, 1.0),
        )
        ratio, way, *_ = stroke_and_ratio(recorded(mechanism, EXTREMES, plans=["positions"]), "B")
        assert (ratio, way) == pytest.approx((K_v, stroke), rel=EXACT)


def four_bar(
    lengths: Mapping[str, float], origin: complex, pivot: complex, sense: int
) -> Mechanism:
    return Mechanism(
        Link(0, {"O": origin, "C": pivot}),
        (
            Link(1, {"O": 0j, "A": complex(lengths["OA"])}),
            Link(2, {"A": 0j, "B": complex(lengths["AB"])}, side=Side(sense, ("A", "C"))),
            Link(3, {"B": complex(lengths["BC"]), "C": 0j}),
        ),
        Drive(1, 1.0),
    )


def test_the_plan_of_a_crank_rocker_has_the_swing_and_the_ratio() -> None:
    rng, done = np.random.default_rng(4), 0
    while done < CASES:
        psi, K_v = float(rng.uniform(20, 90)), float(rng.uniform(1.05, 1.5))
        given = {"psi": psi, "K_v": K_v, "BC": 0.1, "OC": float(rng.uniform(0.06, 0.25))}
        try:
            chosen = choose_four_bar(given)
        except StructureError:
            continue
        done += 1
        mechanism = four_bar(lengths_found("crank-rocker", given), chosen.pivot, 0j, chosen.sense)
        ratio, _, first, last = stroke_and_ratio(
            recorded(mechanism, EXTREMES, plans=["positions"]), "B"
        )
        assert ratio == pytest.approx(K_v, rel=EXACT)
        # the board's origin is O
        swung = cmath.phase((first + chosen.pivot) / (last + chosen.pivot))
        assert math.degrees(swung) == pytest.approx(psi, rel=EXACT)


def random_coupler(rng: np.random.Generator) -> tuple[dict[str, float], list[list[complex]]]:
    """The lengths of a task of three places, and O, C, the places of A and of B."""
    A = [complex(*rng.uniform(-0.1, 0.1, 2)) for _ in range(3)]
    angles = rng.uniform(-60, 60, 3)
    found = lengths_found("coupler", {"A": A, "angles": angles.tolist(), "AB": 0.1})
    ends = [complex(found[f"x{k}"], found[f"y{k}"]) for k in "OC"]
    B = [a + cmath.rect(0.1, math.radians(angle)) for a, angle in zip(A, angles, strict=True)]
    return found, [ends, A, B]


def test_the_plan_of_a_coupler_without_defects_goes_through_its_places() -> None:
    rng, done = np.random.default_rng(5), 0
    while done < CASES:
        found, (ends, A, B) = random_coupler(rng)
        (origin, pivot), words = ends, [word for word, _ in defects((ends[0], ends[1]), A, B)]
        if set(words) & {"apart", "past"}:
            continue
        done += 1
        sense = 1 if ((B[0] - A[0]) / (pivot - A[0])).imag > 0.0 else -1
        at = tuple(math.degrees(cmath.phase(a - origin)) for a in A)
        project = recorded(
            four_bar(found, origin, pivot, sense), Row(3, 1, places=at), plans=["positions"]
        )
        plans = KINEMATICS_PLAN.on(project)
        mark = plans.positions.point("B")
        reading = execute(project.construction, project.given | {plans.mu_l: 1.0}, [mark])
        size = max(abs(origin), abs(pivot), 0.1)
        off = np.abs(np.ravel(reading[mark]) - (np.array(B) - origin))
        assert np.all(off < EXACT * size**2 / 0.1)


STEPS = 7200
"""So finely the crank is turned to see which positions hang together."""


def hanging_together(found: Mapping[str, float], ends: list[complex]) -> np.ndarray:
    """Which piece of its motion a four-bar is in at each crank angle, (angle, side); -1: it does not close.

    Followed step by step: from angle to angle on one side; where it can go no further, over to the other.
    """
    a, b, c, d = found["OA"], found["AB"], found["BC"], abs(ends[1] - ends[0])
    far = np.abs(d - a * np.exp(2j * math.pi * np.arange(STEPS) / STEPS))
    closed = (far <= b + c) & (far >= abs(b - c))
    label = np.where(closed[:, None], np.arange(2 * STEPS).reshape(STEPS, 2), -1)
    if not closed.all():
        start = int(np.argmin(closed))
        for k in np.arange(start, start + STEPS) % STEPS:
            if closed[k]:
                before = label[k - 1]
                label[k] = before if closed[k - 1] else (label[k, 0], label[k, 0])
        return label
    label[:] = (0, 1)
    return label


def test_defects_are_those_that_following_the_motion_finds() -> None:
    rng, seen = np.random.default_rng(6), dict[str, int]()
    for _ in range(20 * CASES):
        found, (ends, A, B) = random_coupler(rng)
        label = hanging_together(found, ends)
        line = ends[1] - ends[0]
        turns = [
            (math.degrees(cmath.phase((a - ends[0]) / line)) % 360.0) * STEPS / 360.0 for a in A
        ]
        near = [[int(turn + k) % STEPS for k in (0, 1)] for turn in turns]
        sides = [int(((b - a) / (ends[1] - a)).imag > 0.0) for a, b in zip(A, B, strict=True)]
        pieces = [{int(label[k, side]) for k in two} for two, side in zip(near, sides, strict=True)]
        if any(len(one) > 1 or -1 in one for one in pieces):
            continue  # at the very end of a piece
        apart = tuple(k for k, one in enumerate(pieces, 1) if one != pieces[0])
        past = tuple(k for k, side in enumerate(sides, 1) if side != sides[0])
        due: list[tuple[str, tuple[int, ...]]] = []
        if apart:
            due = [("apart", apart)]
        elif past:
            due = [("past", past)]
        elif (label == -1).any():
            # along the crank's range, from where it cannot be
            start = int(np.argmax(label[:, 0] == -1))
            order = sorted((1, 2, 3), key=lambda k: (turns[k - 1] - start) % STEPS)
            order = order if order.index(1) < order.index(3) else order[::-1]
            due = [] if order == [1, 2, 3] else [("order", tuple(order))]
        told = list(defects((ends[0], ends[1]), A, B))
        assert told == due
        word = told[0][0] if told else ""
        seen[word] = seen.get(word, 0) + 1
    assert {"", "apart", "past", "order"} <= set(seen)


def test_a_defect_is_told(tmp_path: Path) -> None:
    text = """title = "T"
language = "en"
[task]
kind = "coupler"
A = [["0 mm", 0], ["30 mm", "20 mm"], ["50 mm", "60 mm"]]
angles = ["10 deg", "170 deg", "70 deg"]
AB = "80 mm"
[synthesis]
[[sheet]]
format = "A3"
"""
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    (board,) = in_usual_size(read(path), exact=True).boards
    (line,) = WARNINGS.warnings(board, "en")
    assert line.startswith("synthesis: the mechanism found reaches position")


TASK = """title = "T"
language = "en"
[task]
{task}
[synthesis]
[[sheet]]
format = "A3"
"""


@pytest.mark.parametrize(
    ("task", "key", "words"),
    [
        ('kind = "slider-crank"\nstroke = 0.1\nK_v = 1.2', "task.e", '"e" is missing'),
        ('kind = "slider-crank"\nstroke = 0.1\nK_v = 1.2\ne = 0.5', "task.e", "S/tan θ = 340.6 mm"),
        ('kind = "cylinder"\nstroke = 0.1\npsi = 40\ne = 0.1', "task.e", "has no use of e beside stroke, psi"),
        ('kind = "cylinder"\nstroke = 0.1', "task.psi", '"psi" is missing'),
        ('kind = "rocker"\nK_v = 1.4\nstroke = 0.1', "task.OB", '"OB" is missing'),
        ('kind = "coupler"\nA = [[0, 0], [1, 0], [2, 0]]\nangles = [0, 1, 2]\nAB = 1', "task.A", "in one line"),
        ('kind = "crank-rocker"\npsi = 40\nK_v = 1.2\nBC = 0.1\nOC = 5', "task.OC", "with OC = "),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_task_stands_at_its_key(
    tmp_path: Path, task: str, key: str, words: str
) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(TASK.format(task=task), encoding="utf-8")
    with pytest.raises(SceneError) as error:
        read(path)
    (fault,) = error.value.faults
    assert fault.key == key
    assert words in fault.message


def test_a_drawing_without_a_task_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text('title = "T"\n[synthesis]\n[[sheet]]\nformat = "A3"\n', encoding="utf-8")
    with pytest.raises(SceneError, match=r"write \[task\]"):
        read(path)


def test_the_scene_has_the_published_lengths_on_both_ways() -> None:
    (board,) = (b for b in in_usual_size(scene("found-slider")).boards if b.board == "synthesis")
    made, calculated = SYNTHESIS_PLAN.on(board), CALCULATED.on(board)
    for name, due in (("OA", 47.795), ("AB", 113.722)):
        assert 1000.0 * board.value(calculated[name]) == pytest.approx(due, abs=5e-4)
        # read with a ruler of 0.1 mm at 1:1, the crank as half a difference
        assert 1000.0 * board.value(made.measured[name]) == pytest.approx(due, abs=0.11)


def test_found_places_and_those_counted_from_the_crank_have_letters_of_their_own() -> None:
    """The task counts from its own zero, what is given of the mechanism from O: xC is not x_OC."""
    told = scene("three-positions")
    found = lengths_found("coupler", told.task.given) if told.task is not None else {}
    rows = {one.symbol: one.value for one in given(told)}
    assert rows["x_{OC}"] == pytest.approx(found["xC"] - found["xO"])
    assert rows["y_{OC}"] == pytest.approx(found["yC"] - found["yO"])
    assert not {"x_{C}", "y_{C}"} & set(rows)
