"""Polygons, groups and the lever read the log: every step leaves ink or a prick, nothing is drawn besides."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import shapely
from support.each import each
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.force_views import LOADED, loaded_drawing, views_of
from support.gallery import SHEETS, drawn, in_usual
from support.loaded import weighed
from support.mechanisms import sample
from support.rewritten import text_of
from support.sheets_of_random import FORCES

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.ink_arrows import Arrows, ArrowText
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.chapters.forces.views import force_table, force_views
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.given import drawn_as
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Ink, Stroke, line
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.shapes import shape
from graphic_tmm.paper.symbols.dimensions import SHAFT
from graphic_tmm.paper.symbols.kinematic import ARROW_LENGTH
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


def held(work: Drawn, place: int) -> None:
    """The laws of a figure in one position; equations are no picture of the log.

    The line of a force that is nothing has no direction, and cannot be drawn.
    """
    log, views = work.construction, views_of(work, place)
    shown = [view for view in views if view.shows]
    assert shown
    names = {name for view in shown for name in view.shows}
    steps = [step for step in log.steps if step.it.view in names]
    there = [step for step in steps if is_there(work, step.it, place)]
    assert not without_ink(log._replace(steps=tuple(there)), shown)
    for view in shown:
        assert not without_source(view), view.name
        assert_pictures_make_the_view(log, view)


def is_there(work: Drawn, mark: Mark, place: int) -> bool:
    value = work.reading[mark]
    parts = value if isinstance(value, tuple) else (value,)
    return all(np.isfinite(row[0, place if row.shape[1] > 1 else 0]) for row in parts)


@pytest.mark.slow
@pytest.mark.parametrize("name", LOADED)
def test_steps_of_the_forces_of_a_scene_are_their_ink(name: str) -> None:
    work = drawn(name, exact=True)
    for place in FORCES_PLAN.on(work).places[:2]:
        held(work, place)


@pytest.mark.slow
def test_steps_of_the_forces_of_random_mechanisms_are_their_ink(
    many: Callable[[int, int], int],
) -> None:
    for k, one in enumerate(sample(many(16, 5), seed=410, dyads=(1, 3))):
        couples, balance = ("moment", "pair")[k % 3 == 0], ("force", "moment")[k % 4 == 0]
        way = {"turned": bool(k % 2), "couples": couples, "balance": balance}
        work = loaded_drawing(weighed(one, k), one, **way)
        held(work, 0)


def test_the_lever_shows_all_points_of_the_plan_and_the_couples() -> None:
    work = in_usual("lever")
    made = FORCES_PLAN.on(work)
    (place, *_) = made.places
    view = next(one for one in views_of(work, place) if one.name.startswith("lever"))
    letters = {name for label in view.labels for name in label.text.split(", ")}
    assert {"p", "a", "b", "d", "e"} <= letters
    told = {dict(s.data).get("segment") for s in view.strokes}
    assert {
        one.letter.translate({ord(c): None for c in "_{}"}) for one in made.first.lever.couples
    } <= told


def test_arrows_on_a_detached_group_are_of_conventional_length() -> None:
    for name in ("windrower", "lever"):
        work = in_usual(name)
        for view in views_of(work, FORCES_PLAN.on(work).places[0]):
            if view.name.startswith("group"):
                lengths = [
                    abs(complex(*s.path[0][:2]) - complex(*s.path[-1][:2]))
                    for s in view.strokes
                    if s.pen == "over" and not s.filled and dict(s.data).get("segment")
                ]
                assert max(lengths) <= 40.0
                assert min(lengths) >= 12.0 - SHAFT * ARROW_LENGTH  # the shaft ends in the head


@pytest.mark.slow
def test_couples_and_what_balances_stand_in_the_printed_table_with_their_signs() -> None:
    """As machines are told them: the sheet, the note and `table` say the same."""
    work = drawn("lever")
    (table,) = force_table(work, True)
    (place,) = FORCES_PLAN.on(work).places
    printed = {
        label.text: float(figures[-1].text.replace("−", "-").replace(",", "."))
        for label in table.labels
        if label.text.startswith(("M_{и", "P_{ур"))
        for figures in [
            sorted(
                (one for one in table.labels if one.at.imag == label.at.imag),
                key=lambda one: one.at.real,
            )
        ]
    }
    columns = {column.segment: column for column in force_columns(work)}
    told = {
        symbol(column.letter, "ru"): column.value[0][place]
        for column in columns.values()
        if column.letter.startswith("M_")
    }
    told["P_{ур}"] = columns["P_bal_forces"].value[0][place]
    assert sum(value < 0.0 for value in told.values()) >= 3
    for letter, value in told.items():
        assert printed[letter] == pytest.approx(value, rel=1e-2), letter


def test_couples_of_friction_stand_about_their_pins_and_forces_touch_the_circles() -> None:
    """The force that stands for a reaction and its couple lies off the pin by the radius of friction.

    Groups are drawn so large that the circles are seen: on the sheet they have a radius of less than 1 mm.
    """
    scene = read(SHEETS / "crank-press")
    (work,) = drawn_as(scene, {"groups": 300.0}, exact=True, wanted=None, mechanism=True)
    marks = {
        mark.slot: mark
        for mark in (*work.construction.given, *(s.it for s in work.construction.steps))
    }
    place, touching, rounds = FORCES_PLAN.on(work).places[0], set(), set()

    def value(slot: int) -> complex:
        row = work.reading[marks[slot]]
        return complex(row[0, place if row.shape[1] > 1 else 0])

    for view in (one for one in views_of(work, place) if one.name.startswith("group")):
        thin = [s for s in view.strokes if isinstance(s, Stroke) and s.pen == "thin"]
        pins = [value(s.of[0]) for s in view.strokes if s.part == "pair"]
        for one in thin:
            if dict(one.data).get("segment", "").startswith("Mf"):
                corners = [complex(x, y) for x, y, _ in one.path]
                apart = [np.ptp([abs(z - middle) for z in corners]) for middle in pins]
                assert min(apart) < 1e-6
                rounds.add(dict(one.data)["segment"])
            if len(one.of) == 5:
                point, radius, couple, tail, head = one.of
                a, b = (complex(x, y) for x, y, _ in one.path)
                force = value(head) - value(tail)
                foot = a + ((value(point) - a) / (b - a)).real * (b - a)
                arm = foot - value(point)
                assert (force / (b - a)).imag == pytest.approx(0.0, abs=1e-9)
                turns = (arm.conjugate() * force).imag / abs(force)
                mu = next(
                    f.mu
                    for f in FORCES_PLAN.on(work).figures
                    if f"{f.view} ".replace(" ", "-") in view.name
                )
                rho = value(radius).real / value(mu.slot).real
                assert turns == pytest.approx(np.sign(value(couple).real) * rho)
                touching.add(one.of)
    assert len(rounds) == 5  # O, A of the crank; A, B of the rod, B of the ram
    assert len(touching) == 4  # at both ends of the crank and of the rod


@pytest.mark.parametrize(
    ("point", "away"),
    [(0j, 1), (0j, -1), (100 + 0j, 1), (100 + 0j, -1), (40 + 0j, 1), (40 + 0j, -1)],
)
def test_a_reaction_along_a_link_stands_off_the_line_of_the_link(point: complex, away: int) -> None:
    """Outside the pair at an end of the link, whichever way it points; beside the link anywhere else."""
    arrows = Arrows(0, 5.0)
    arrows.stands_on([line("main", 0j, 100 + 0j)])
    arrows.put(point, complex(away), 18.0, "R", ArrowText("R", 1.0, "N", (1,)), "thin")
    (x, y, _), _ = arrows.strokes[0].path
    x_end = x + 18.0 * away
    assert shape(arrows.strokes[0]).length <= 18.0
    inside = 0.0 < point.real < 100.0
    assert abs(y) > 3.0 if inside else y == 0.0
    assert inside or not 0.5 < (x + x_end) / 2 < 99.5
    assert min(abs(one - point.real) for one in (x, x_end)) < 1e-9


@each("name", ["crank-press", "tipper", "excavator", "shock-absorber"])
def test_no_reaction_to_be_found_lies_on_a_link_and_no_arrow_in_a_tube(name: str) -> None:
    work = drawn(name, exact=True)
    for view in views_of(work, FORCES_PLAN.on(work).places[0]):
        bars = shapely.union_all([shape(one) for one in view.strokes if one.part == "link"])
        filled = [one._replace(filled=True) for one in view.strokes if _is_tube(one)]
        tubes = shapely.union_all([shape(one) for one in filled])
        for one in view.strokes:
            if (one.pen, *dict(one.data).get("segment", "")[:1]) == ("thin", "R"):
                under = shape(one).intersection(shapely.buffer(bars, 0.6))
                assert under.length < 0.25 * shape(one).length
            if one.pen in ("thin", "over") and "segment" in dict(one.data):
                assert shape(one).intersection(tubes).length <= 0.5 * shape(one).length


def _is_tube(stroke: Ink) -> bool:
    return isinstance(stroke, Stroke) and stroke.part == "cylinder" and stroke.pen == "body"


def test_a_long_guide_of_a_group_ends_at_its_stone(tmp_path: Path) -> None:
    """A stone that goes far over the turn makes no figure of one position larger than all else in it."""
    pick = next(itertools.islice(sample(7, 91, dyads=(1, 3)), 6, None))
    tail = f"accelerations = [1]\n{FORCES}positions = [1]\n"
    file = tmp_path / "scene.toml"
    order = '[[sheet]]\nformat = "A1"\nplace = ["forces"]\n'
    file.write_text(text_of(pick.mechanism, pick.phi, 12, tail + order), encoding="utf-8")
    (work,) = make(read(file)).boards
    (view,) = [one for one in force_views(work, True) if one.name == "group-4-5-1"]
    plan = work.scales["positions"].value / work.scales["group 4-5"].value
    guides = {guide.name: reach for guide, reach in reaches(work).items()}
    longest = max(one.high - one.low for name, one in guides.items() if name in ("4", "5"))
    left, bottom, right, top = bounds(view)
    assert max(right - left, top - bottom) < 0.5 * plan * longest
