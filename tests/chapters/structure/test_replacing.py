"""The replacing linkage moves as the wheels do: by the loops of a linkage that has its points and no wheels."""

from __future__ import annotations

import cmath
from dataclasses import replace as changed

import pytest
from support import gallery
from support.oracle import solve_fast
from support.wheels import geared, near

import graphic_tmm as tmm
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.kinematics.positions import draw_frame, draw_positions
from graphic_tmm.chapters.structure.record import MOBILITY
from graphic_tmm.chapters.structure.replacing import replace, replaced_formula
from graphic_tmm.chapters.structure.views_replacing import replacing_views
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.studio import make

RATIO = 1e-9
"""Of the largest rate."""


def _moves_as_wheels(seed: int, belted: bool) -> None:
    sampled = geared(seed, 1 + seed % 2, belted=belted)
    mechanism = sampled.mechanism
    structure, draft = dissect(mechanism), Draft()
    frame = draw_frame(draft, mechanism, structure)
    angle = draft.board.take(Angle, "φ", "°")
    positions = draw_positions(draft, mechanism, structure, frame, [angle], near(sampled))
    replaced = list(replace(draft, positions))
    log = draft.board.construction()
    scale = {view.scale: 1.0 for view in log.views if view.scale is not None}
    reading = execute(log, {**draft.given, **scale, angle: sampled.phi})
    poses = {mechanism.frame.number: (0.0, 0.0, 0.0), **sampled.poses}
    links = {number: dict(link.points) for number, link in mechanism.by_number.items()}
    origin, more = mechanism.frame.points[structure.origin], []
    for k, one in enumerate(replaced):
        pins = {f"pin{k}": one.rolling.link, f"far{k}": one.rolling.on}
        ends = (complex(reading[mark][0, 0]) + origin for mark in (one.pin, one.far))
        at = dict(zip(pins, ends, strict=True))
        for letter, number in pins.items():
            x, y, turned = poses[number]
            links[number][letter] = (at[letter] - complex(x, y)) * cmath.rect(1.0, -turned)
        first, second = at.values()
        more.append(Link(one.rolling.span, {f"pin{k}": 0j, f"far{k}": abs(second - first) + 0j}))
        poses[one.rolling.span] = (first.real, first.imag, cmath.phase(second - first))
    linkage = Mechanism(
        changed(mechanism.frame, points=links[mechanism.frame.number]),
        (*(changed(link, points=links[link.number]) for link in mechanism.links), *more),
        mechanism.drive,
    )
    own, due = (
        solve_fast(one, sampled.phi, {k: poses[k] for k in one.by_number if k != one.frame.number})
        for one in (linkage, mechanism)
    )
    for found, wanted in ((own.omega, due.omega), (own.epsilon, due.epsilon)):
        top = max(map(abs, wanted.values()))
        for number, value in wanted.items():
            assert abs(found[number] - value) <= RATIO * top, (seed, number)


@pytest.mark.parametrize("belted", [False, True])
def test_it_has_the_rates_of_the_wheels(belted: bool) -> None:
    for seed in range(12):
        _moves_as_wheels(seed, belted)


@pytest.mark.slow
@pytest.mark.parametrize("belted", [False, True])
def test_many_have_the_rates_of_the_wheels(belted: bool) -> None:
    for seed in range(100, 300):
        _moves_as_wheels(seed, belted)


def test_it_is_drawn_with_its_groups_where_it_is_asked_for() -> None:
    text = (gallery.SHEETS / "geared-five-bar" / "scene.toml").read_text("utf-8")
    assert make(tmm.read(text)).mechanism is not None
    drawn = make(
        tmm.read(text.replace('"structure"]', '"structure", "replacing linkage"]'))
    ).mechanism
    assert drawn is not None
    made = MOBILITY.of(drawn)
    assert made is not None
    (one,) = made.replaced
    assert (one.name, [mark.name for mark in (one.pin, one.far)]) == ("4-6", ["N4", "N1"])
    assert [drawn.reading[mark].item() for mark in made.replacing.values()] == [1.0, 0.0]
    assert drawn.scene.mechanism is not None
    assert replaced_formula(dissect(drawn.scene.mechanism)) == "I(1) → II(4-6) → II(2-3)"
    whole, group = replacing_views(drawn, True)
    assert {label.text for label in group.labels} >= {"4", "6"}
    assert {label.text for label in whole.labels} >= {"1", "2", "3", "4", "5", "6"}
    plain = make(tmm.read(text)).mechanism
    assert plain is not None
    assert replacing_views(plain, True) == []
