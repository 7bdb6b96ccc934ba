"""A plan's lines read as those of the book: letters are freed, scale factors found."""

from __future__ import annotations

import pytest

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import coriolis, in_si, normal, rate, rescaled, to_board
from graphic_tmm.board.operations.instruments import join, lay_off, measure, ray
from graphic_tmm.board.record import TALLY, Mark
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.errors import ConstructionError


def _plans() -> tuple[Draft, dict[str, Mark]]:
    """Return a draft with plans of positions, velocities and accelerations; what was read in each."""
    draft, marks = Draft(), dict[str, Mark]()
    for view, letter, pole, unit in (
        ("positions", "μ_l", "O", "m"),
        ("velocities", "μ_v", "p", "m/s"),
        ("accelerations", "μ_a", "π", "m/s²"),
    ):
        draft.open(view)
        marks[letter] = draft.scale(letter, f"({unit})/mm")
        marks[unit] = draft.take(Number, "q", 1.0, unit)
        if view == "positions":
            draft.mu_l = marks[letter]
        origin = draft.take(Point, pole, 0j)
        draft.lay_out(origin, marks[letter])
        line = draft.draw(ray, "m", origin, draft.direction(0.0))
        end = draft.draw(lay_off, "e", line, draft.take(Length, "l", 1.0))
        marks[view] = draft.draw(measure, "oe", origin, end)
    marks["ω"] = draft.take(Number, "ω", 1.0, "1/s")
    return draft, marks


def _used(draft: Draft, mark: Mark, marks: dict[str, Mark]) -> list[str]:
    """Return what a step used, by the names that the test gave."""
    names = {mark: name for name, mark in marks.items()}
    return [names[used] for used in draft.uses(mark)]


def test_a_scale_factor_is_that_of_the_view_where_its_length_was_read() -> None:
    draft, m = _plans()
    link, ab = m["positions"], m["velocities"]
    draft.open("velocities")
    turning = draft.draw(rate, "ω_2", ab, link, unit="1/s")
    assert _used(draft, turning, m) == ["velocities", "μ_v", "positions", "μ_l"]
    draft.open("accelerations")
    inward = draft.draw(normal, "n", ab, link)
    assert _used(draft, inward, m) == ["velocities", "μ_v", "positions", "μ_l", "μ_a"]
    sideways = draft.draw(coriolis, "k", m["ω"], ab)
    assert _used(draft, sideways, m) == ["ω", "velocities", "μ_v", "μ_a"]
    told = draft.draw(in_si, "a", m["accelerations"], unit="m/s²")
    assert _used(draft, told, m) == ["accelerations", "μ_a"]


def test_a_length_that_is_calculated_is_to_the_scale_of_the_view_that_is_open() -> None:
    draft, m = _plans()
    for view, mu, unit in (
        ("velocities", "μ_v", "m/s"),
        ("accelerations", "μ_a", "m/s²"),
        ("positions", "μ_l", "m"),
    ):
        draft.open(view)
        assert _used(draft, draft.draw(to_board, "y", m[unit]), m) == [unit, mu]


def test_a_view_without_a_scale_of_its_own_is_drawn_to_that_of_lengths() -> None:
    draft, m = _plans()
    draft.open("group 2-3")
    assert _used(draft, draft.draw(to_board, "h", m["m"]), m) == ["m", "μ_l"]


def test_a_quantity_is_not_drawn_to_the_scale_of_another() -> None:
    """What a view without a scale of its own falls back to is found out by the units."""
    draft, m = _plans()
    draft.open("group 2-3")
    with pytest.raises(ConstructionError, match="to_board 'h'"):
        draft.draw(to_board, "h", m["m/s"])


def test_a_real_length_is_drawn_to_the_scale_of_lengths_in_every_view() -> None:
    draft, m = _plans()
    draft.open("velocities")
    assert draft.uses(draft.length("OA", 1.0))[1] == m["μ_l"]


def test_scale_factors_may_be_told() -> None:
    draft, m = _plans()
    other = m["other"] = draft.ask(Number, "μ", "m/mm")
    assert _used(draft, draft.draw(to_board, "y", m["m"], other), m) == ["m", "other"]
    told = draft.draw(rescaled, "y", m["positions"], m["μ_l"], other)
    assert _used(draft, told, m) == ["positions", "μ_l", "other"]


def test_some_but_not_all_scale_factors_are_refused() -> None:
    draft, m = _plans()
    with pytest.raises(
        ConstructionError, match=r"rate 'ω' takes \(Length, Number, Length, Number\)"
    ):
        draft.draw(rate, "ω", m["velocities"], m["μ_v"], m["positions"])
    with pytest.raises(ConstructionError, match=r"join 'm' takes \(Point, Point\)"):
        draft.draw(join, "m")


def test_lengths_have_no_scale_before_it_is_taken() -> None:
    draft = Draft()
    draft.open("positions")
    with pytest.raises(
        ConstructionError, match="positions: the scale factor of lengths, μ_l, is not"
    ):
        draft.length("OA", 1.0)


def test_letters_are_freed_but_for_those_of_points() -> None:
    draft, m = _plans()
    draft.open("positions")
    origin = draft.uses(m["positions"])[0]
    line = draft.draw(ray, "m", origin, draft.direction(90.0))
    assert (line.letter, line.name) == (f"m{TALLY}", "m")
    with pytest.raises(ConstructionError, match="the letter 'e' stands in this plan already"):
        draft.draw(lay_off, "e", line, m["positions"])
    again = draft.draw(lay_off, "e", line, m["positions"], free=True, role="end")
    assert (again.letter, again.name, again.role) == (f"e{TALLY}", "e", "end")
    assert draft.board.construction().roles("positions", "end") == (again,)
