"""What the survey needs before it can draw: a side for every group with two assemblies."""

from __future__ import annotations

import pytest
from test_assembly import coulisse, four_bar, message, slider_crank

from graphic_tmm.mechanism.records import Link, Mechanism, Slide


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
