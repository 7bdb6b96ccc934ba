"""Vector equations: those of the textbook for each kind of group, read off the log, true in numbers."""

from __future__ import annotations

import re

import numpy as np
import pytest
from support.boards import drawn_of
from support.driven_scenes import BOOM, OUT, scene
from support.each import each
from support.gallery import PLANS, in_usual
from support.plates import machine
from support.words_of_drives import FIVE_BAR, OPEN_CRANK, TURNS

import graphic_tmm
from graphic_tmm import read
from graphic_tmm.board.record import Construction, Mark, segment_name
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.kinematics.ink_plans import draw_equations
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.views import acceleration_equations, velocity_equations
from graphic_tmm.mechanism.groups import AssurGroup, Group, PlateGroup, SquareGroup
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.mechanism.wheels import Rolling
from graphic_tmm.project import record
from graphic_tmm.readers.equations import Equation, components, ends_of, equations, quantity
from graphic_tmm.readers.narration import protocol
from graphic_tmm.readers.table import columns_of


def _lettered(log: Construction, plan: str, letter: str) -> Mark | None:
    """Return the mark that readers find under a letter of a plan."""
    marks = (*log.given, *(step.it for step in log.steps))
    return next((mark for mark in marks if mark.key == (plan, letter)), None)


def found(name: str, plan: str) -> list[Equation]:
    work = in_usual(name)
    turned = work.scene.turned and plan == "velocities"
    return list(equations(work.project.construction, plan, turned=turned))


def test_the_equations_of_a_crank_and_slider() -> None:
    (velocity,) = found("engine", "velocities")
    assert velocity.group == "II(2-3)"
    assert velocity.markup == r"\u{\bar{v}_{B}} = \uu{\bar{v}_{A}} + \u{\bar{v}_{BA}}"
    assert velocity.directions == "v_{B} ∥ x–x, v_{BA} ⊥ AB"
    (acceleration,) = found("engine", "accelerations")
    assert acceleration.text == "a_B = a_A + a_BA^n + a_BA^t"
    assert acceleration.markup.count(r"\uu{") == 2
    assert acceleration.directions == "a_{B} ∥ x–x, a_{BA}^{n}: B → A, a_{BA}^{t} ⊥ AB"


@pytest.mark.slow
def test_a_rocker_with_a_stone_has_a_coriolis_term_known_wholly() -> None:
    first, second = found("windrower", "accelerations")
    assert first.text == "a_A3 = a_A + a_A3A^k + a_A3A^r = a_A3B^n + a_A3B^t"
    assert r"\uu{\bar{a}_{A3A}^{k}} + \u{\bar{a}_{A3A}^{r}}" in first.markup
    assert first.markup.startswith(r"\bar{a}_{A3} =")  # its direction is not known beforehand
    assert second.text == "a_D = a_C + a_DC^n + a_DC^t"


def test_a_turned_plan_has_the_same_equations_as_a_direct_one() -> None:
    log = in_usual("engine").project.construction
    (turned,) = equations(log, "velocities", turned=True)
    (mistaken,) = equations(log, "velocities", turned=False)
    assert "v_{BA} ⊥ AB" in turned.directions
    assert "v_{BA} ∥ AB" in mistaken.directions
    (direct,) = equations(in_usual("offset-slider").project.construction, "velocities")
    assert direct.directions == turned.directions


def test_a_plan_without_a_pole_or_not_drawn_has_none() -> None:
    log = in_usual("tangent-mechanism").project.construction
    assert list(equations(log, "positions")) == []
    assert list(equations(log, "nothing")) == []


def equated(name: str, plan: str) -> list[AssurGroup | Rolling]:
    """Groups and, on plans of accelerations, wheels: that of velocities reads a wheel off its pitch point.

    A plate has two: that of its special point, that of its third pin. Of two plates that links join the special
    point's accelerations have two, for they differ.
    """
    structure = KINEMATICS_PLAN.on(in_usual(name)).structure
    row = structure.groups if plan == "velocities" else structure.attached
    twice = (PlateGroup,) if plan == "velocities" else (PlateGroup, SquareGroup)
    return [one for group in row for one in (group,) * (1 + isinstance(group, twice))]


def kind_of(one: AssurGroup | Rolling) -> str:
    if isinstance(one, Group):
        return "group"
    if isinstance(one, PlateGroup):
        return "plate"
    if isinstance(one, SquareGroup):
        return "square"
    return "belted" if one.mesh.belted else "wheel"


@each("name, plan", PLANS)
def test_every_group_has_its_equation_and_two_vectors_known_in_direction_only(
    name: str, plan: str
) -> None:
    called = {
        "group": "II({})",
        "plate": "III({})",
        "square": "IV({})",
        "wheel": "p4({})",
        "belted": "p4({}) by a flexible link",
    }
    groups = [called[kind_of(one)].format(one.name) for one in equated(name, plan)]
    assert [e.group for e in found(name, plan)] == groups
    for equation in found(name, plan):
        assert equation.markup.count(r"\u{") == 2  # as many unknowns as a plane equation solves


@each("name, plan", PLANS)
def test_the_sides_of_an_equation_are_equal_on_the_plan(name: str, plan: str) -> None:
    """Along its known direction, the unknown vector is what the rest of the side leaves."""
    work = in_usual(name)
    reading = work.reading if plan == "velocities" else work.of("accelerations")
    assert reading is not None
    log = work.project.construction
    lengths: dict[str, Mark] = {}
    for mark in work.project.marks(plan):
        if mark.kind.__name__ == "Length":
            lengths.setdefault(quantity(mark, components(log)), mark)
    for equation in found(name, plan):
        point = _lettered(
            log, plan, re.sub(r"[va]_|[{}]", "", equation.text.split(" =")[0]).lower()
        )
        assert point is not None
        for side in equation.sides:
            known = [term for term in side if term.known]
            unknown = side[-1]
            assert not unknown.known
            assert all(term.known for term in side[:-1])
            start = _lettered(log, plan, known[0].symbol[2:].strip("_{}").lower())
            total = np.abs(reading[point] - (reading[start] if start is not None else 0.0)) ** 2
            parts = [t for t in side if t.direction]
            if len(parts) > 2:
                continue  # a rod's: its Coriolis part and the tangential one lie along one line
            read = [reading[lengths[t.symbol]] for t in parts if t.symbol in lengths]
            unread = [t.marks for t in parts if t.symbol not in lengths]
            assert not unread or dissect(work.scene.mechanism).rank > 1
            squares = sum(np.abs(one) ** 2 for one in read)
            squares = squares + sum(np.abs(reading[b] - reading[a]) ** 2 for a, b in unread)
            assert np.allclose(total, squares, rtol=1e-9, atol=1e-9), equation.text


@pytest.mark.parametrize(
    ("letter", "due"),
    [
        ("pb", "v_{B}"),
        ("aa3", "v_{A3A}"),
        ("πs2", "a_{S2}"),
        ("p1b", "v_{BP1}"),  # from the image of a point P1, not from the pole
        ("pp1", "v_{P1}"),
        ("π1k3", "v_{K3Π1}"),
        ("ωb", "v_{BΩ}"),  # from the image of a point Ω: no rate
    ],
)
def test_a_segment_stands_for_its_quantity(letter: str, due: str) -> None:
    assert quantity(Mark(0, letter, Length, "velocities"), {}) == due


@pytest.mark.every
@pytest.mark.parametrize(
    ("name", "due"),
    [
        (
            "windrower",
            {
                "ak2": "a_{A3A}^{k}",
                "k2a3": "a_{A3A}^{r}",
                "πn3": "a_{A3B}^{n}",
                "n3a3": "a_{A3B}^{t}",
            }
            | {"cn4": "a_{DC}^{n}", "n4d": "a_{DC}^{t}"},
        ),
        (
            "accelerating-crank",
            {"πn1": "a_{A}^{n}", "n1a": "a_{A}^{t}", "an2": "a_{BA}^{n}", "n2b": "a_{BA}^{t}"},
        ),
    ],
)
def test_components_are_declared_where_they_are_recorded(name: str, due: dict[str, str]) -> None:
    found = components(in_usual(name).project.construction)
    assert {mark.name: letter for mark, letter in found.items()} == due


def test_the_ends_of_a_segment() -> None:
    assert ends_of("aa3") == ["a", "a3"]
    assert ends_of("s2b′") == ["s2", "b′"]
    assert ends_of("2") == ["2"]


@pytest.mark.parametrize(
    ("letter", "due"), [("ω_2", "omega2"), ("ε_{12}", "epsilon12"), ("ωb", "ωb"), ("n3a3", "n3a3")]
)
def test_a_rate_is_a_rate_by_its_index(letter: str, due: str) -> None:
    assert segment_name(letter) == due


@pytest.mark.parametrize("language", ["en", "ru"])
@each("name, plan", PLANS)
def test_no_heading_of_a_group_can_be_read_as_a_parallel(
    name: str, plan: str, language: str
) -> None:
    view = lettered(name, plan, language)
    assert not any(text.startswith("II") for text in view)
    heads = {
        "group": {"en": "group {} of class II:", "ru": "группа {} II класса:"},
        "plate": {"en": "group {} of class III:", "ru": "группа {} III класса:"},
        "square": {"en": "group {} of class IV:", "ru": "группа {} IV класса:"},
        "wheel": {"en": "wheel {} with its higher pair:", "ru": "колесо {} с высшей парой:"},
        "belted": {"en": "wheel {} with its flexible link:", "ru": "колесо {} с гибкой связью:"},
    }
    due = [heads[kind_of(one)][language].format(one.name) for one in equated(name, plan)]
    # a plate on three legs has two equations under one heading
    assert [text for text in view if text.endswith(":")] == list(dict.fromkeys(due))


def test_the_pin_of_a_crank_that_speeds_up_has_two_components() -> None:
    told = lettered("accelerating-crank", "accelerations", "en")
    assert told[1].startswith("a_{A}^{n} = ω_1²")
    assert told[2].startswith("a_{A}^{t} = ε_1")
    assert told[3] == r"\bar{a}_{A} = \uu{\bar{a}_{A}^{n}} + \uu{\bar{a}_{A}^{t}}"
    assert lettered("engine", "accelerations", "en")[1].startswith("a_A = ω_1²")


@pytest.mark.parametrize(
    ("gains", "due"),
    [
        ("", ["a_A", "a_C"]),
        ("acceleration = 3\n", ["a_{A}^{n}", "a_{A}^{t}", r"\bar{a}_{A}", "a_C"]),
    ],
)
def test_what_two_cranks_give_to_their_pins_is_no_sum(gains: str, due: list[str]) -> None:
    further = "[[drive]]\nlink = 4\nspeed = 10\nat = 1\n"
    first = OPEN_CRANK.replace("[drive]", "[[drive]]") + TURNS + gains
    work = drawn_of(read(f'title = "T"\nlanguage = "en"\n{FIVE_BAR}{first}{further}'), exact=True)
    (velocities,), (accelerations,) = (
        velocity_equations(work, True),
        acceleration_equations(work, True),
    )
    assert [x.text.split(" = ")[0] for x in velocities.labels[1:3]] == ["v_A", "v_C"]
    heads = [x.text.split(" = ")[0] for x in accelerations.labels[1:]]
    assert heads[: heads.index("group 2-3 of class II:")] == due


def lettered(name: str, plan: str, language: str) -> list[str]:
    log = in_usual(name).project.construction
    view = draw_equations(log, plan, "Equations", found(name, plan), language=language)
    return [label.text for label in view.labels]


@each("way", ["", '[plans]\nvelocities = "turned"\n'])
def test_a_rod_runs_out_and_turns_with_its_cylinder(way: str) -> None:
    """Every letter names a point of the scheme: what is left of v_NG beside v_r is square to the rod."""
    accelerates = OUT + 'accelerations = "all"\n' + way
    work = drawn_of(scene(BOOM, accelerates), exact=True)
    (velocity,) = equations(work.construction, "velocities", turned=bool(way))
    assert velocity.text == "v_N = v_r + v_NG^t"
    assert velocity.directions == "v_{N} ⊥ ON, v_r ∥ GN, v_{NG}^{t} ⊥ GN"
    (acceleration,) = equations(work.construction, "accelerations")
    assert acceleration.text == "a_N = a_NO^n + a_NO^t = a_NG^k + a_NG^n + a_NG^t"
    (column,) = (c for c in columns_of(work) if c.quantity == "v_{NG}^{t}")
    lengths = np.linspace(0.6, 0.85, 6)
    motion = graphic_tmm.motion(scene(BOOM, OUT), lengths, exact=True)
    due = np.abs(motion.omega[2]) * lengths
    np.testing.assert_allclose(column.value[0], due, rtol=1e-9)
    why = {step.it.key: step.why for step in work.construction.steps}
    assert "turns together with its cylinder" in why["velocities", "(k2n)"]


def test_a_rod_that_is_held_in_its_cylinder_is_a_rigid_link() -> None:
    work = in_usual("excavator")
    first, second = equations(work.project.construction, "velocities by drive 3")
    assert first.text == "v_N = v_r3 + v_NG^t"
    assert second.text == "v_M = v_B + v_MB = v_H + v_MH"


def test_figures_of_points_are_indices_on_a_sheet() -> None:
    """Of a plate on three legs: ⊥ W₃F, as its special point is lettered on the plan of positions."""
    velocity, acceleration = (
        found("swinging-screen", plan)[-1] for plan in ("velocities", "accelerations")
    )
    assert re.search(r"⊥ W_\{\d\}[A-Z]", velocity.directions)
    assert re.search(r"[A-Z] → W_\{\d\}", acceleration.directions)


def test_a_plate_has_the_equation_of_its_special_point_and_that_of_its_pin() -> None:
    """What steps and notes print under the heading of its group: both, in the order of solving."""
    made = in_usual("swinging-screen")
    lines = protocol(made.construction, "velocities", made.reading, 1, "en")
    printed = [line.text for line in lines if line.equation is not None]
    special = next(k for k, text in enumerate(printed) if re.match(r"v_W\d = ", text))
    assert re.search(r"= v_W\d \+ v_[A-Z]W\d;", printed[special + 1])


def test_legs_that_both_hold_on_to_the_frame_tell_both_directions() -> None:
    """Of a plate with two sliders the special point rests; no pivot has a letter that could stand for it."""
    log = record(read(machine(102, guides=2).text)).construction
    first, _ = equations(log, "velocities")
    assert first.directions == "v_{W5} ∥ q_{1}–q_{1}, ∥ q_{2}–q_{2}"
    first, _ = equations(log, "accelerations")
    assert first.text == "a_W5 = a_W5C^n + a_W5^t = a_W5F^n + a_W5^t"
