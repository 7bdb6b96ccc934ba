"""What is told of one reading that is off: how it was perhaps written."""

from __future__ import annotations

import pytest
from support.own_student.machines import MACHINES
from support.own_student.student import student
from support.own_told import kind_of, report_of

from graphic_tmm.checking.mutations.slip_of_reading import written_amiss
from graphic_tmm.checking.records import WRONG, Judged, Taken


@pytest.mark.parametrize(
    ("found", "due", "signed", "says"),
    [
        (4.55, 45.3, False, "its decimal point has perhaps slipped"),
        (-4550.0, 45.3, True, "its decimal point has perhaps slipped"),
        (-45.0, 45.3, True, "it bears the other sign"),
        (-45.0, 45.3, False, "this reading was read or written down amiss"),
        (63.5, 36.2, False, "two of its digits are perhaps exchanged"),
        (66.5, 36.2, False, "this reading was read or written down amiss"),
        (3.0, 0.0, False, "this reading was read or written down amiss"),
    ],
)
def test_how_a_reading_is_perhaps_written(
    found: float, due: float, signed: bool, says: str
) -> None:
    taken = Taken("velocities", "1", "pb", mm=found, line=2, signed=signed)
    assert written_amiss(Judged(taken, found, due, found - due, 0.0, 0.0, WRONG)) == says


def test_a_rate_of_the_other_sign_is_told_as_that() -> None:
    kind = kind_of("sign of omega2")
    drawing = student(MACHINES["rpr"], 591003, kind, way="mm and values", mu=None, mu_rows=True)
    assert drawing.truth is not None
    (slip,) = report_of(drawing).mistakes
    assert slip.position == str(drawing.truth.position)
    assert slip.says.endswith("is off: it bears the other sign")
