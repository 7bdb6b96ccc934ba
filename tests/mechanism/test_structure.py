"""Structure: mobility, groups, formula; every wrong structure named by its links."""

from __future__ import annotations

import itertools
import random
from contextlib import suppress
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.chains import chain
from support.examples import most
from support.gallery import SHEETS
from support.lettered_links import FOUR_BAR, X, Y, link, mechanism
from support.mechanisms import KINDS, Sampled, mechanisms, sample
from support.plates import machine
from support.squares import square

import graphic_tmm as tmm
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.groups import PlateGroup, SquareGroup
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Side, Slide
from graphic_tmm.mechanism.structure import Structure, dissect, driven_otherwise
from graphic_tmm.scene.read import read

pytestmark = pytest.mark.every


def parts(structure: Structure) -> list[tuple[str, str, tuple[int, int]]]:
    return [(pair.kind, pair.name, pair.links) for pair in structure.pairs]


def windrower() -> Mechanism:
    return read(SHEETS / "windrower").mechanism


def test_the_windrower_has_the_published_structure() -> None:
    found = dissect(windrower())
    assert found.moving == 5
    assert len(found.pairs) == 7
    assert found.mobility == 1
    assert [(group.name, group.kind) for group in found.groups] == [("2-3", 3), ("4-5", 2)]
    assert found.formula == "I(1) → II(2-3) → II(4-5)"
    assert (found.origin, found.first.pin, found.first.link) == ("O", "A", 1)
    assert {(kind, name, frozenset(links)) for kind, name, links in parts(found)} == {
        ("R", "O", frozenset({1, 6})),
        ("R", "A", frozenset({1, 2})),
        ("R", "B", frozenset({3, 6})),
        ("R", "C", frozenset({3, 4})),
        ("R", "D", frozenset({4, 5})),
        ("P", "BC", frozenset({2, 3})),
        ("P", "y", frozenset({5, 6})),
    }


@pytest.mark.parametrize(
    ("name", "formula", "kinds"),
    [
        ("engine", "I(1) → II(2-3)", [2]),
        ("oscillating-cylinder", "I(1) → II(2-3)", [3]),
        ("scotch-yoke", "I(1) → II(2-3)", [5]),
        ("crank-rocker", "I(1) → II(2-3)", [1]),
        ("tangent-mechanism", "I(1) → II(2-3) → II(4-5)", [1, 4]),
        ("toggle-press", "I(1) → II(2-3) → II(4-5)", [1, 2]),
    ],
)
def test_the_scenes_have_the_structure_of_the_textbook(
    name: str, formula: str, kinds: list[int]
) -> None:
    found = dissect(read(SHEETS / name).mechanism)
    assert found.formula == formula
    assert [group.kind for group in found.groups] == kinds


@pytest.mark.parametrize("kind", KINDS)
def test_the_kind_of_a_group_is_told_by_its_pairs(kind: str) -> None:
    for drawn in sample(40, seed=7, dyads=(1, 1), kinds=[kind]):
        found = dissect(drawn.mechanism)
        assert [group.kind for group in found.groups] == [KINDS.index(kind) + 1]


@pytest.mark.slow
@settings(max_examples=most(100), deadline=None)
@given(drawn=mechanisms(), seed=st.integers(0, 1000))
def test_the_order_of_links_is_irrelevant(drawn: Sampled, seed: int) -> None:
    given_order = drawn.mechanism
    links = list(given_order.links)
    random.Random(seed).shuffle(links)
    shuffled = Mechanism(given_order.frame, tuple(links), given_order.drive)
    first, second = dissect(given_order), dissect(shuffled)
    assert first.mobility == second.mobility == 1
    assert first.formula == second.formula
    assert [(g.kind, g.links, g.legs) for g in first.groups] == [
        (g.kind, g.links, g.legs) for g in second.groups
    ]
    assert parts(first) == parts(second)


def test_every_order_of_a_six_link_mechanism_gives_the_same_formula() -> None:
    given_order = windrower()
    found = set()
    for links in itertools.permutations(given_order.links):
        found.add(dissect(Mechanism(given_order.frame, links, given_order.drive)).formula)
    assert found == {"I(1) → II(2-3) → II(4-5)"}


def test_groups_are_attached_only_to_what_is_there() -> None:
    for drawn in sample(100, seed=3, dyads=(2, 3)):
        found = dissect(drawn.mechanism)
        there = {drawn.mechanism.frame.number, found.first.link}
        for group in found.groups:
            assert {leg.body for leg in group.legs} <= there
            there |= set(group.links)
        assert there == set(drawn.mechanism.by_number)


def test_a_pivot_of_three_links_makes_two_pairs() -> None:
    found = dissect(
        mechanism(
            *FOUR_BAR, link(4, "BD"), link(5, "D", Slide(0, X)), frame=Link(0, {"O": 0j, "C": 4j})
        )
    )
    at_b = [pair for pair in found.pairs if pair.name == "B"]
    assert [pair.links for pair in at_b] == [(2, 3), (2, 4)]
    assert len(found.pairs) == 7
    assert found.formula == "I(1) → II(2-3) → II(4-5)"


def test_two_rods_on_the_crank_pin_make_two_groups() -> None:
    found = dissect(
        mechanism(
            link(1, "OA"),
            link(2, "AB"),
            link(3, "B", Slide(0, X)),
            link(4, "AD"),
            link(5, "D", Slide(0, Y)),
        )
    )
    assert found.formula == "I(1) → II(2-3) → II(4-5)"
    assert [pair.links for pair in found.pairs if pair.name == "A"] == [(1, 2), (1, 4)]


def test_a_group_may_stand_on_the_frame_under_any_number() -> None:
    frame = Link(4, {"O": 0j, "C": 4j})
    assert dissect(mechanism(*FOUR_BAR, frame=frame)).formula == "I(1) → II(2-3)"


def test_another_driving_link_changes_the_formula() -> None:
    assert dissect(mechanism(*FOUR_BAR, drive=3)).formula == "I(3) → II(1-2)"


def test_a_plate_on_three_legs_is_a_group_of_class_three() -> None:
    links = link(1, "OA"), link(2, "AB"), link(3, "BDE"), link(4, "DC"), link(5, "EF")
    frame = Link(0, {"O": 0j, "C": 4j, "F": 5 + 0j})
    for row in (links, links[::-1]):
        structure = dissect(Mechanism(frame, row, Drive(1, 1.0)))
        (group,) = structure.groups
        assert isinstance(group, PlateGroup)
        assert (group.plate, [leg.link for leg in group.legs]) == (3, [2, 4, 5])
        assert structure.formula == "I(1) → III(2-3-4-5)"


def test_two_plates_that_two_links_join_are_a_group_of_class_four() -> None:
    square = link(2, "ABE"), link(3, "BD"), link(4, "EF"), link(5, "DFC")
    links = link(1, "OA"), *square, link(6, "DG"), link(7, "GH")
    frame = Link(0, {"O": 0j, "C": 4j, "H": 5 + 0j})
    for row in (links, links[::-1]):
        structure = dissect(Mechanism(frame, row, Drive(1, 1.0)))
        group = structure.groups[0]
        assert isinstance(group, SquareGroup)
        assert (group.plates, group.joining) == ((2, 5), (3, 4))
        assert [[pair.name for pair in two] for two in group.inner] == [["B", "D"], ["E", "F"]]
        assert structure.formula == "I(1) → IV(2-3-4-5) → II(6-7)"


def test_a_dyad_comes_before_a_plate_and_behind_it() -> None:
    links = link(1, "OA"), link(2, "AB"), link(3, "BDE"), link(4, "DC"), link(5, "EF")
    more = link(6, "AG"), link(7, "GH"), link(8, "BK"), link(9, "KL")
    frame = Link(0, {"O": 0j, "C": 4j, "F": 5 + 0j, "H": 6j, "L": 7j})
    formula = dissect(Mechanism(frame, (*links, *more), Drive(1, 1.0))).formula
    assert formula == "I(1) → II(6-7) → III(2-3-4-5) → II(8-9)"


def test_a_frame_of_guides_alone_is_asked_for_a_point() -> None:
    links = link(1, "A", Slide(0, X)), link(2, "AB"), link(3, "B", Slide(0, Y))
    drive = Drive(1, 0.5, slides=True)
    with pytest.raises(StructureError, match=r"the frame has no point .* O = \[0, 0\]"):
        dissect(Mechanism(Link(0, {}), links, drive))
    assert dissect(Mechanism(Link(0, {"O": 0j}), links, drive)).origin == "O"


def test_side_does_not_enter_the_structure() -> None:
    sided = Link(2, FOUR_BAR[1].points, side=Side(-1, ("A", "C")))
    assert dissect(mechanism(FOUR_BAR[0], sided, FOUR_BAR[2])).formula == "I(1) → II(2-3)"


@pytest.mark.slow
@settings(max_examples=most(150), deadline=None)
@given(drawn=mechanisms(dyads=(1, 2)), data=st.data())
def test_a_pair_taken_away_is_always_refused(drawn: Sampled, data: st.DataObject) -> None:
    """Whatever letter or slide is taken off a link, the answer is a structure or a StructureError."""
    links = list(drawn.mechanism.links)
    place = data.draw(st.integers(0, len(links) - 1))
    victim = links[place]
    if victim.slides and data.draw(st.booleans()):
        changed = Link(victim.number, victim.points, victim.guides, victim.slides[1:])
    else:
        gone = data.draw(st.sampled_from(sorted(victim.points)))
        rest = {k: v for k, v in victim.points.items() if k != gone}
        changed = Link(victim.number, rest, victim.guides, victim.slides)
    links[place] = changed
    before = len(dissect(drawn.mechanism).pairs)
    broken = Mechanism(drawn.mechanism.frame, tuple(links), drawn.mechanism.drive)
    try:
        found = dissect(broken)
    except StructureError:
        return
    # only a letter that made no pair can go without harm
    assert len(found.pairs) == before


def by_trying(mechanism: Mechanism) -> list[set[int]]:
    """The groups in their order, each found by trying all pairs of links that are left."""
    bodies = {link.number: link for link in (mechanism.frame, *mechanism.links)}
    known = [mechanism.frame.number, mechanism.drive.link]
    left = sorted(bodies.keys() - set(known))

    def pins(one: int, others: list[int]) -> int:
        return len(bodies[one].points.keys() & {p for k in others for p in bodies[k].points})

    def ties(one: int, others: list[int]) -> int:
        slides = sum(s.on in others for s in bodies[one].slides)
        slides += sum(s.on == one for k in others for s in bodies[k].slides)
        return pins(one, others) + slides

    found = []
    while left:
        there = {p for k in known for p in bodies[k].points}
        for one, other in itertools.combinations(left, 2):
            shared = (bodies[one].points.keys() & bodies[other].points.keys()) & there
            inner = ties(one, [other]) - len(shared)
            if ties(one, known) == ties(other, known) == inner == 1:
                break
        else:
            raise AssertionError(left)
        assert pins(one, known) + pins(other, known) + pins(one, [other]), "three sliding pairs"
        found.append({one, other})
        known += [one, other]
        left = [k for k in left if k not in (one, other)]
    return found


@pytest.mark.parametrize("seed", range(3))
def test_groups_come_in_the_order_that_trying_all_links_gives(seed: int) -> None:
    drawn = [one.mechanism for one in sample(60, seed=seed, dyads=(1, 5))]
    rng = random.Random(seed)
    for one in [*drawn, chain(9)]:
        links = rng.sample(one.links, len(one.links))
        shuffled = Mechanism(one.frame, tuple(links), one.drive)
        assert [set(group.links) for group in dissect(shuffled).groups] == by_trying(one)


def tied(mechanism: Mechanism, link: Link) -> bool:
    """Whether a link could be a crank, or a slider, on the frame: one letter or one slide of it is there."""
    letters = link.points.keys() & mechanism.frame.points.keys()
    if link.slides:
        return not letters and [slide.on for slide in link.slides] == [mechanism.frame.number]
    return len(letters) == 1 and len(link.points) > 1


def by_trying_all_drives(mechanism: Mechanism) -> dict[int, list[set[int]]]:
    """The groups of two links of a mechanism by the link that drives it, where these are all its groups."""
    found = {}
    for own in mechanism.links:
        if own.number != mechanism.drive.link and tied(mechanism, own):
            with suppress(AssertionError):
                found[own.number] = by_trying(replace(mechanism, drive=Drive(own.number, 1.0)))
    return found


@pytest.mark.parametrize("seed", range(3))
def test_links_that_could_drive_are_those_that_trying_all_drives_gives(seed: int) -> None:
    drawn = [one.mechanism for one in sample(40, seed=seed, dyads=(1, 4))]
    drawn += [
        tmm.read(machine(10 * seed + k, guides=guides, slots=slots).text).mechanism
        for k, (guides, slots) in enumerate((g, s) for g in range(4) for s in range(4 - g))
    ]
    drawn += [tmm.read(square(10 * seed + k).text).mechanism for k in range(9)]
    several = 0
    for one in drawn:
        otherwise = [other for other in driven_otherwise(one) if other.numeral in ("I", "II")]
        found = {
            other.first.link: [set(group.links) for group in other.groups] for other in otherwise
        }
        assert found == by_trying_all_drives(one)
        several += len(found) > 0
        of_four = [group for group in dissect(one).groups if len(group.plates) == 2]
        # each plate of a square on the frame, driven, leaves the other one on three legs
        assert not of_four or {other.numeral for other in driven_otherwise(one)} == {"III"}
    assert several > len(drawn) // 2
