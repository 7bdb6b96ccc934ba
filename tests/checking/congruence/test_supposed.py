"""Scale factors that a plan with a mistake may have: supposed, where they explain readings better."""

from __future__ import annotations

import pytest
from support.own_told import kind_of, report_of, told, with_mistake

from graphic_tmm.checking.congruence.lengths import Group, Read
from graphic_tmm.checking.congruence.supposed import SUPPOSED, supposed
from graphic_tmm.checking.congruence.witnesses import Verdict

VELOCITIES = Group("velocities", 0.025, "m/s", (1,))


def lengths(*ratios: float) -> list[Read]:
    """Return pa twice as long in all positions, another segment by its own ratios."""
    laid = [Read(str(k), "pa", 160.0, 80.0, laid=True) for k in range(len(ratios))]
    return [*laid, *(Read(str(k), "ab", 60.0 * r, 60.0) for k, r in enumerate(ratios))]


def test_what_is_laid_off_first_says_a_scale_factor_beside_a_mistake() -> None:
    read = lengths(0.7, 1.5, 2.9, 0.4)
    (one,) = supposed({VELOCITIES: Verdict()}, {VELOCITIES: Verdict()}, {VELOCITIES: read}, ())
    assert (one[VELOCITIES].times, one[VELOCITIES].by) == (2.0, SUPPOSED)


def test_most_lengths_say_it_where_nothing_is_laid_off_first() -> None:
    forces = Group("forces", 4.0, "N", (1,))
    read = [Read(str(k), "R12", 50.0 * r, 50.0) for k, r in enumerate((0.5, 0.5, 0.51, 1.7, 0.9))]
    (one,) = supposed({forces: Verdict()}, {forces: Verdict()}, {forces: read}, ())
    assert one[forces].times == pytest.approx(0.5)


def test_nothing_is_supposed_of_what_is_stated_or_as_long_as_due() -> None:
    found = {VELOCITIES: Verdict()}
    assert supposed(found, found, {VELOCITIES: lengths(0.7, 1.5, 2.9)}, [VELOCITIES]) == []
    read = [one._replace(mm=one.due) for one in lengths(1.0, 1.0, 1.0)]
    assert supposed(found, found, {VELOCITIES: read}, ()) == []


def test_what_rates_say_is_supposed_where_lengths_say_another() -> None:
    """Lengths are all 3.33 times as long, rates say 0.6: a diameter was taken for a radius."""
    found = {VELOCITIES: Verdict(3.33, "round", rates=1.667)}
    one = supposed(found, found, {VELOCITIES: lengths(2.0, 2.0)}, ())[0]
    assert one[VELOCITIES].times == pytest.approx(1.667)


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", ["t along the link", "arc of AB with a wrong opening"])
@pytest.mark.slow
def test_a_mistake_is_named_in_a_scale_factor_that_nothing_states(name: str) -> None:
    drawing = with_mistake(kind_of(name), 0, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert told(report, drawing).name
    assert [one.by for one in report.scales if one.plan == "velocities"] == [SUPPOSED]
    assert any("with the mistake that is named" in says for says in report.head)


def test_lengths_read_from_the_ruler_s_1_cm_mark_have_the_scale_factor_of_what_is_left() -> None:
    dues = (20.0, 35.0, 50.0, 65.0, 80.0)
    read = [Read(str(k), "ab", due / 1.2 + 10.0, due) for k, due in enumerate(dues)]
    found = {VELOCITIES: Verdict()}
    (one,) = supposed(found, found, {VELOCITIES: read}, ())
    assert one[VELOCITIES].times == pytest.approx(1.0 / 1.2)
