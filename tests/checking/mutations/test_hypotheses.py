"""Which hypothesis is told, and how sure: no name that fits what it moves badly, no name surer than it is."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from graphic_tmm.checking.mutations.hypotheses import Hypothesis, Rest, best, tempered, told_of
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.tables import Variation
from graphic_tmm.checking.records import MISTAKE


def hypothesis(score: float, moved: int = 0, squares: float = 0.0, name: str = "a") -> Hypothesis:
    """Return a hypothesis of a table of three rows, of nothing that matters but its figures."""
    rows = np.arange(3)
    one, nothing = np.ones(3, complex), np.zeros(3, complex)
    what = Variation(MISTAKE, "table", name, rows, one, nothing, {}, plan=name)
    gain = np.array([score, 0.0])
    return Hypothesis(what, -1, None, score, gain, 0, 0, np.zeros(2), moved, squares)


@pytest.mark.parametrize("moved", [1, 2, 5, 12, 40, 200])
def test_a_fit_is_bad_if_chance_makes_it_once_in_a_thousand(moved: int) -> None:
    def chance(squares: float) -> float:
        return float(mpmath.gammainc(moved / 2, squares / 2, regularized=True))

    limit = next(s for s in np.arange(0.0, 2000.0, 0.05) if not hypothesis(1, moved, s).fits)
    assert 0.5e-3 < chance(limit) < 2e-3


def test_what_moves_nothing_fits() -> None:
    assert hypothesis(1.0).fits


def test_the_best_explanation_is_no_name_if_it_fits_badly() -> None:
    good, bad = hypothesis(40.0, 8, 7.0), hypothesis(40.0, 8, 42.0)
    assert best([good], Rest()) is not None
    assert best([bad], Rest()) is None
    assert best([bad, hypothesis(30.0, 8, 7.0, "b")], Rest()) is None, "nor is the next one then"


def test_of_two_explanations_one_must_be_clearly_better() -> None:
    def sure(lead: float) -> bool:
        return best([hypothesis(40.0 + lead), hypothesis(40.0, name="b")], Rest()) is not None

    assert not sure(2.0), "odds of seven to one, by errors that hang together"
    assert sure(3.5)


@pytest.mark.parametrize(("share", "told"), [(0.5, 0.5), (16 / 17, 0.8), (1.0, 1.0), (0.0, 0.0)])
def test_how_sure_it_is_told(share: float, told: float) -> None:
    with np.errstate(divide="ignore"):
        assert tempered(float(np.log(share))) == pytest.approx(told, abs=1e-6)


def test_what_no_reading_tells_apart_is_told_as_one_of_a_few_and_no_surer_than_that() -> None:
    alike = [hypothesis(40.0, name=name) for name in "abcdefgh"]
    told, sure = told_of((tuple(alike), 0.99), ())
    assert len(told) == 3
    assert sure == pytest.approx(0.99 * 3 / 8)
    told, sure = told_of((tuple(alike[:2]), 0.99), ())
    assert [one.what.plan for one in told] == ["a", "b"]
    assert sure == pytest.approx(0.99)


def test_what_is_so_in_the_table_is_told_as_surely_whatever_drew_it_so() -> None:
    """A column of the other sign is that, by whichever of six steps it came about; another column is not."""
    column = hypothesis(40.0)
    drawn = [
        column._replace(what=Mutation(family, "", {}, {}, usual=3.0), board=0)
        for family in ("sense", "start", "factor", "operand", "power", "mirrored")
    ]
    told, sure = told_of(((column, *drawn), 0.99), ())
    assert told[0] is column
    assert sure == pytest.approx(0.99)
    assert told_of((tuple(drawn), 0.99), ())[1] == pytest.approx(0.99 / 2)
