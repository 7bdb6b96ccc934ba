"""Every wrong structure is refused, named by its links, with what may be done about it."""

from __future__ import annotations

import re

import pytest
from support.each import each
from support.lettered_links import FOUR_BAR, X, Y, Z, link, mechanism

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Link, Mechanism, Slide
from graphic_tmm.mechanism.structure import dissect

pytestmark = pytest.mark.every

WRONG: dict[str, tuple[Mechanism, tuple[str, ...]]] = {
    "a pair is missing": (
        mechanism(link(1, "OA"), link(2, "AB"), link(3, "BD")),
        ("W = 3·3 − 2·3 = 3", "one drive", "a pair is missing", "O(1,0)", "A(1,2)", "B(2,3)"),
    ),
    "a pair is too many": (
        mechanism(link(1, "OA"), link(2, "AB", Slide(0, X)), link(3, "BC")),
        ("W = 3·3 − 2·5 = −1", "a pair is too many", "C(3,0)", "x(2,0)"),
    ),
    "W = 2 by one link more": (
        mechanism(*FOUR_BAR, link(4, "BD")),
        ("W = 3·4 − 2·5 = 2", "a pair is missing"),
    ),
    "tied to nothing": (
        mechanism(*FOUR_BAR, link(4, "XY")),
        ("link 4 is tied to nothing", "slide"),
    ),
    "three plates in a ring": (
        mechanism(
            link(1, "OA"),
            link(2, "ABE"),
            link(3, "BD"),
            link(4, "DFC"),
            link(5, "FG"),
            link(6, "GHK"),
            link(7, "HE"),
            frame=Link(0, {"O": 0j, "C": 4j, "K": 5 + 0j}),
        ),
        ("2, 3, 4, 5, 6, 7", "class above IV"),
    ),
    "a square with a sliding pair": (
        mechanism(
            link(1, "OA"),
            link(2, "ABE"),
            link(3, "B", Slide(5, X)),
            link(4, "EF"),
            link(5, "FC", guides=(X,)),
            frame=Link(0, {"O": 0j, "C": 4j}),
        ),
        (
            "2, 3, 4, 5",
            "class IV",
            "turning ones",
            "driven by link 5 the mechanism is of class III, I(5)",
        ),
    ),
    "a square with a double pin": (
        mechanism(
            link(1, "OA"),
            link(2, "ABE"),
            link(3, "BD"),
            link(4, "ED"),
            link(5, "DC"),
            frame=Link(0, {"O": 0j, "C": 4j}),
        ),
        ("3",),
    ),
    "a link that slides at both ends holds a plate": (
        mechanism(
            link(1, "OA"),
            link(2, "B", Slide(1, X), Slide(3, Z)),
            link(3, "DE", guides=(Z,)),
            link(4, "D", Slide(0, Y)),
            link(5, "E", Slide(0, X)),
        ),
        ("links 2, 4, 5 and 3", "one sliding pair; links 2 do not", "driven by link 4"),
    ),
    "two shared letters": (
        mechanism(link(1, "OA"), link(2, "AB"), link(3, "AB")),
        ("links 2 and 3 share A and B", "one link"),
    ),
    "a letter and a slide shared": (
        mechanism(link(1, "OA"), link(2, "AB", Slide(3, Z)), link(3, "BC", guides=(Z,))),
        ("links 2 and 3 share B and z",),
    ),
    "two slides shared": (
        mechanism(link(1, "OA"), link(2, "A", Slide(3, Z), Slide(3, Y)), link(3, "C")),
        ("links 2 and 3 share z and y",),
    ),
    "the drive off the frame": (
        mechanism(*FOUR_BAR, drive=2),
        ("driving link 2", "shares none"),
    ),
    "the drive on two pivots": (
        mechanism(link(1, "OC"), link(2, "CB"), link(3, "BO")),
        ("driving link 1", "O, C"),
    ),
    "the drive slides": (
        mechanism(link(1, "A", Slide(0, X)), link(2, "AB"), link(3, "BC")),
        ("driving link 1",),
    ),
    "the drive is the frame": (mechanism(*FOUR_BAR, drive=0), ("link 0", "not a moving link")),
    "the drive is unknown": (mechanism(*FOUR_BAR, drive=9), ("link 9", "not a moving link")),
    "no crank pin": (
        mechanism(link(1, "O", guides=(Z,)), link(2, "B", Slide(1, Z)), link(3, "BC")),
        ("link 1", "second letter"),
    ),
    "three sliding pairs": (
        mechanism(
            link(1, "OA", guides=(Z,)),
            link(2, "D", Slide(1, Z), Slide(3, Y)),
            link(3, "E", Slide(0, X)),
        ),
        ("links 2 and 3", "three sliding pairs"),
    ),
    "slides on itself": (
        mechanism(link(1, "OA"), link(2, "AB"), link(3, "B", Slide(3, X))),
        ("link 3 slides on itself",),
    ),
    "tied to each other only": (
        mechanism(
            *FOUR_BAR,
            link(4, "DE"),
            link(5, "EF"),
            link(6, "FD"),
            link(7, "AX"),
            link(8, "X", Slide(0, X)),
            link(9, "BY"),
            link(10, "Y"),
        ),
        ("W =",),
    ),
}


@each("name", WRONG)
def test_a_wrong_structure_is_named_by_its_links(name: str) -> None:
    wrong, words = WRONG[name]
    with pytest.raises(StructureError) as caught:
        dissect(wrong)
    for word in words:
        assert word in str(caught.value)


@each("name", WRONG)
def test_the_links_may_stand_in_any_order_and_the_message_tells_the_same(name: str) -> None:
    wrong, _ = WRONG[name]
    told = []
    for links in (wrong.links, wrong.links[::-1]):
        with pytest.raises(StructureError) as caught:
            dissect(Mechanism(wrong.frame, links, wrong.drive))
        told.append(sorted(re.findall(r"[^\W\d]+", str(caught.value))))
    assert told[0] == told[1]


def test_a_group_that_is_not_drawn_is_refused_with_the_driving_link_by_which_it_is() -> None:
    frame = Link(0, {"O": 0j, "D": 4 + 0j, "E": 5 + 0j, "G": 6 + 0j})
    plates = link(2, "AB"), link(3, "BCJ"), link(4, "CD"), link(5, "JFH")
    made = mechanism(link(1, "OA"), *plates, link(6, "FE"), link(7, "HG"), frame=frame)
    formula = "I(6) → II(5-7) → II(3-4) → II(1-2)"
    with pytest.raises(StructureError, match=re.escape(formula)) as refused:
        dissect(made)
    assert "write [drive] link = 6" in str(refused.value)
    assert dissect(mechanism(*made.links, frame=frame, drive=6)).formula == formula
