"""The notes of other drives, of what stands, of several cylinders: what a teacher would miss."""

from __future__ import annotations

import pytest
from note.test_notes_of_engines import told
from support.each import each
from support.notes import made, noted

from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.note.document import (
    Heading,
    Number,
    Picture,
    SideBySide,
    Table,
    Text,
    numbers,
    walk,
)

pytestmark = pytest.mark.slow


def figures(name: str) -> set[str]:
    found = [block for block in walk(noted(name).blocks) if isinstance(block, Picture | SideBySide)]
    parts = [one for block in found for one in getattr(block, "parts", (block,))]
    return {one.id for one in parts}


def legend(name: str) -> str:
    """The table of symbols as plain text."""
    (found,) = (
        block
        for block in walk(noted(name).blocks)
        if isinstance(block, Table) and block.id == "table-symbols"
    )
    return repr(found.rows)


@each("name", ["toggle-clamp", "hand-clamp"])
def test_what_stands_has_possible_velocities_at_a_rate_that_is_told(name: str) -> None:
    heads = [block for block in walk(noted(name).blocks) if isinstance(block, Heading)]
    titles = ["".join(run.text for run in head.runs if isinstance(run, Text)) for head in heads]
    assert "План возможных скоростей" in titles
    assert "План скоростей" not in titles
    assert "планы возможных скоростей строятся при" in told(name)


def test_the_force_that_is_sought_is_concluded() -> None:
    assert "искомая сила равна 364, выигрыш в силе 1,82." in told("hand-clamp").replace(" Н", "")


def test_a_moment_on_the_lever_is_worked_out() -> None:
    assert "M_{ур}^{Ж}===30,78" in told("toggle-clamp")


@each("link", [3, 6])
def test_the_arms_of_each_lever_are_those_on_its_own_plan(link: int) -> None:
    (drawn,) = made("excavator").boards
    lever = next(
        one.lever for one in FORCES_PLAN.on(drawn).balanced if one.driven.pair.link == link
    )
    (table,) = (
        block
        for block in walk(noted("excavator").blocks)
        if isinstance(block, Table) and block.id == f"table-lever-{link}"
    )
    told = [[run for cell in row for run in cell if isinstance(run, Number)] for row in table.rows]
    for (size, arm, moment), force in zip(told, lever.forces, strict=True):
        pole, point, line = (drawn.reading[one] for one in (lever.pole, force.point, force.line))
        way = (point[0, arm.source.place] - pole[0, 0]).conjugate()
        along = line.along[0, min(arm.source.place, line.along.shape[1] - 1)]
        assert abs(arm.value - (way * along).imag) <= 0.05 + 1e-9
        assert abs(moment.value - size.value * arm.value) <= 1e-9 * abs(moment.value)


def test_what_moments_give_has_one_sign_in_its_equation_and_behind_it() -> None:
    (drawn,) = made("excavator").boards
    forces = FORCES_PLAN.on(drawn)
    sought = {str(one.value.slot) for group in forces.groups for one in group.tangents.values()}
    sought |= {str(one.lever.force.slot) for one in forces.balanced}
    told: dict[str, list[bool]] = {}
    for one in numbers(noted("excavator")):
        if one.source.kind in ("mark", "size") and one.source.name in sought:
            told.setdefault(one.source.name, []).append(one.text.startswith("−"))
    assert set(told) == sought
    assert max(map(len, told.values())) >= 2  # the tangential ones are laid off too
    assert all(len({*signs}) == 1 for signs in told.values())
    assert [True] in [sorted({*signs}) for signs in told.values()]


def test_groups_with_rods_have_their_figures() -> None:
    """Called as the formula of structure calls their groups, a rod being part of its cylinder."""
    assert {
        f"fig-{what}-{links}-1" for what in ("group", "forces") for links in ("4-5", "1-2")
    } <= (figures("excavator"))


@each("language, words", [("ru", "на 360° позже"), ("en", "360° later")])
def test_a_cylinder_that_fires_later_is_given(language: str, words: str) -> None:
    assert words in told("v-engine", language)


@each(
    "name, there, missing",
    [
        (
            "toggle-clamp",
            ("уравновешивающий момент", "плечо"),
            ("сила инерции", "момент сил инерции", "ускорени"),
        ),
        ("hand-clamp", ("выигрыш в силе",), ("сила инерции", "ускорени")),
        ("excavator", ("заданная скорость привода", "сила инерции", "ускорение точки"), ()),
        ("gripper", ("ускорение точки",), ("сила инерции", "заданная скорость")),
    ],
)
def test_the_list_of_symbols_has_what_stands_in_the_note(
    name: str, there: tuple[str, ...], missing: tuple[str, ...]
) -> None:
    rows = legend(name)
    assert [word for word in there if word not in rows] == []
    assert [word for word in missing if word in rows] == []


@each(
    "name, words",
    [
        ("v-engine", "Цилиндр C. Давления на поршень"),
        ("engine", "Давления на поршень"),
        ("crank-press", "по перемещению точки B"),
    ],
)
def test_what_is_given_point_by_point_stands_in_the_task(name: str, words: str) -> None:
    found = [
        block
        for block in walk(noted(name).blocks)
        if isinstance(block, Table) and block.id.startswith("table-listed-")
    ]
    assert any(words in repr(table.caption) for table in found)
    assert all(len(row) == len(table.heads) for table in found for row in table.rows)
