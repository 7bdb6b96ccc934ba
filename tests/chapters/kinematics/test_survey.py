"""What the survey needs before it can draw: one clear side for every group with two assemblies."""

from __future__ import annotations

import pytest
from support.assemblies import message
from support.boards import recorded
from support.linkages import coulisse, four_bar, slider_crank
from support.rows import places

from graphic_tmm.mechanism.records import Link, Mechanism, Row, Side, Slide


@pytest.mark.parametrize(
    ("mechanism", "remedy"),
    [
        (four_bar(0.1, 0.4, 0.3, 0.45), 'link 2 or 3 side = "left of AC"'),
        (slider_crank(0.1, 0.4), 'slides of link 3 side = "+" or "-"'),
        (coulisse(0.1, 0.3 + 0j), 'slides of link 2 side = "+" or "-"'),
    ],
)
def test_a_missing_side_is_asked_for_by_its_key(mechanism: Mechanism, remedy: str) -> None:
    bare = tuple(
        Link(
            link.number,
            link.points,
            link.guides,
            tuple(Slide(s.on, s.guide, s.offset, s.angle) for s in link.slides),
        )
        for link in mechanism.links
    )
    text = message(Mechanism(mechanism.frame, bare, mechanism.drive))
    assert "group 2-3 can be assembled in two ways" in text
    assert remedy in text


def sided(**sides: Side) -> Mechanism:
    """A four-bar with sides on the links named."""
    bare = four_bar(0.1, 0.4, 0.3, 0.45)
    links = (
        Link(link.number, link.points, side=sides.get(f"link{link.number}")) for link in bare.links
    )
    return Mechanism(bare.frame, tuple(links), bare.drive)


@pytest.mark.parametrize("ends", [("O", "C"), ("A", "B"), ("B", "C"), ("O", "A")])
@pytest.mark.parametrize("number", [2, 3])
def test_a_side_of_other_letters_than_the_outer_pivots_is_refused(
    number: int, ends: tuple[str, str]
) -> None:
    text = message(sided(**{f"link{number}": Side(1, ends)}))
    assert f"link {number}" in text
    assert "".join(ends) in text
    assert 'side = "left of AC" or "right of AC"' in text


def test_two_sides_that_contradict_each_other_are_refused() -> None:
    for other in (Side(-1, ("A", "C")), Side(1, ("C", "A")), Side(1, ("A", "C"), (10.0,))):
        text = message(sided(link2=Side(1, ("A", "C")), link3=other))
        assert "links 2 and 3" in text
        assert "leave" in text


def test_left_of_one_way_is_right_of_the_other() -> None:
    kept = [
        sided(link2=Side(1, ("A", "C"))),
        sided(link3=Side(-1, ("C", "A"))),
        sided(link2=Side(1, ("A", "C")), link3=Side(-1, ("C", "A"))),
    ]
    found = [places(recorded(one, Row(5), plans=["positions"]), "B") for one in kept]
    for row in found:
        assert (row == found[0]).all()
        assert (row.imag > 0).all()  # to the left of the way from A to C
