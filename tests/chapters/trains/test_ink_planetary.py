"""The planetary train in ink: everything stands where the log has it, letters stand clear."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import combinations
from typing import NamedTuple

import numpy as np
import pytest
import shapely
from support.each import each

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.trains.ink import Captions, draw_planetary_ink
from graphic_tmm.chapters.trains.plan import Planetary, draw_planetary
from graphic_tmm.chapters.trains.table import (
    condition_table,
    rate_table,
    ratio_lines,
    train_table,
)
from graphic_tmm.chapters.trains.task import PlanetaryTask
from graphic_tmm.chapters.trains.tooth_search import search
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.symbols.kinematic import HATCH_DEPTH, RIM
from graphic_tmm.paper.write.svg import svg

C7 = PlanetaryTask("ring", 0.008, 302.4, ratio=4.55, tolerance=0.003, teeth=(25, None, None))
ORDERS = {
    "C7": C7,
    "ring, five": PlanetaryTask("ring", 0.004, -100.0, ratio=3.2, tolerance=0.05, satellites=(5,)),
    "external-internal": PlanetaryTask("external-internal", 0.004, 302.0, ratio=12.0),
    "external-external": PlanetaryTask("external-external", 0.004, 302.0, ratio=-0.5, tolerance=0.03),
    "external-external, H": PlanetaryTask("external-external", 0.004, 302.0, "H", ratio=60.0),
    "internal-internal": PlanetaryTask("internal-internal", 0.004, 302.0, "H", ratio=-40.0, tolerance=0.05),
    "internal-internal, two": PlanetaryTask(
        "internal-internal", 0.004, -302.0, "H", ratio=20.0, tolerance=0.05, satellites=(2,)
    ),
}  # fmt: skip
ORDERS |= {
    f"{name}, behind": replace(ORDERS[name], behind=((15, 25),))
    for name in ("C7", "internal-internal", "external-external")
}
WALL = HEIGHTS["A1"]
CAPTIONS = Captions(
    ("Схема планетарного редуктора", "μ_l = 0,005 м/мм"),
    ("Картина линейных скоростей", "μ_v = 0,5 (м/с)/мм"),
    ("План угловых скоростей", "μ_ω = 4 с⁻¹/мм, H_ω = 25 мм"),
)


class Inked(NamedTuple):
    made: Planetary
    log: Construction
    reading: Reading
    drawing: Drawing


@cache
def inked(name: str, lettered: bool = True) -> Inked:
    draft = Draft()
    made = draw_planetary(draft, ORDERS[name])
    log = draft.board.construction()
    reading = execute(log, draft.given)
    view = draw_planetary_ink(Subject(log, reading, "Редуктор", WALL), made, CAPTIONS)
    return Inked(made, log, reading, finished(view, lettered))


def lines(of: Drawing, *pens: str) -> list[tuple[complex, complex]]:
    found = [s for s in of.strokes if isinstance(s, Stroke) and s.pen in pens]
    ends = [[complex(x, y) for x, y, _ in s.path] for s in found if not s.closed]
    return [(path[0], path[-1]) for path in ends if len(path) == 2]


def circles(of: Drawing, pen: str = "main") -> list[tuple[complex, float]]:
    found = []
    for s in of.strokes:
        if isinstance(s, Stroke) and s.pen == pen and s.closed and not s.filled and s.path[0][2]:
            a, b = (complex(x, y) for x, y, _ in s.path)
            found.append(((a + b) / 2, abs(b - a) / 2))
    return found


@pytest.mark.parametrize("name", ORDERS)
def test_every_pitch_circle_stands_in_its_place_to_scale(name: str) -> None:
    made, _, reading, view = inked(name)
    drawn, scheme = circles(view), made.train.scheme
    mu = float(reading[made.mu][0, 0])
    axes = [complex(z) for z in reading[made.end.satellites][0]]
    for wheel, z in zip(scheme.wheels, made.train.teeth, strict=True):
        module = made.order.module
        centres = [0j] if wheel in ("1", scheme.wheels[-1]) else axes
        for centre in centres:
            near = [abs(c - centre) + abs(r - module * z / 2 / mu) for c, r in drawn]
            assert min(near) < 1e-9
    assert len(axes) == made.train.satellites


@pytest.mark.parametrize("name", ORDERS)
def test_rays_are_parallel_to_the_lines_of_the_picture(name: str) -> None:
    made, _, reading, view = inked(name)
    pole = complex(reading[made.rates.pole][0, 0])
    bodies = lines(view, "main")
    rays = [(a, b) for a, b in lines(view, "medium") if abs(a - pole) < 1e-9]
    assert len(rays) == 3
    place = complex(reading[made.picture.zeros["O"]][0, 0]).real
    tips = [complex(reading[mark][0, 0]).real for mark in made.picture.ends.values()]
    for a, b in rays:
        way = (b - a) / abs(b - a)
        along = [
            abs(((d - c) / abs(d - c) * np.conj(way)).imag)
            for c, d in bodies
            if min(c.real, d.real) > min(place, *tips) - 1e-6 and abs(d - c) > 1e-6
        ]
        assert min(along) < 1e-9


@pytest.mark.parametrize("name", ORDERS)
def test_the_line_of_the_satellites_goes_through_all_three_of_its_points(name: str) -> None:
    made, _, reading, view = inked(name)
    spots = [
        complex(reading[m][0, 0]) for m in (*made.picture.ends.values(), made.picture.zeros["C"])
    ]
    through = [shapely.LineString([(z.real, z.imag) for z in ends]) for ends in lines(view, "main")]
    assert any(
        all(one.distance(shapely.Point(z.real, z.imag)) < 1e-6 for z in spots) for one in through
    )


@pytest.mark.parametrize("name", ORDERS)
def test_letters_stand_clear_of_each_other(name: str) -> None:
    labels = inked(name).drawing.labels
    assert all(box(a).disjoint(box(b)) for a, b in combinations(labels, 2))
    texts = [label.text for label in labels]
    made = inked(name).made
    for wheel in (*made.train.scheme.wheels, "H", "O", "A", "B", "C", "P"):
        assert any(wheel in text.split(", ") for text in texts)
    assert {"a", "b"} <= set(texts)


@pytest.mark.parametrize("name", ["C7", "ring, five", "external-external"])
def test_letters_stand_clear_of_heavy_lines(name: str) -> None:
    view = inked(name).drawing
    heavy = [shape(s) for s in view.strokes if s.pen in ("main", "rod", "joint")]
    assert all(box(label).disjoint(line) for label in view.labels for line in heavy)


@pytest.mark.parametrize("name", ORDERS)
def test_an_unlettered_train_takes_about_the_room_of_a_lettered_one(name: str) -> None:
    bare = inked(name, lettered=False).drawing
    assert bare.cell is not None
    room, view = shapely.box(*bare.cell), inked(name).drawing
    assert all(room.covers(shape(s)) for s in view.strokes if s.part != "leader")
    assert all(room.buffer(15.0).covers(box(label)) for label in view.labels)


def test_the_letter_of_the_contact_with_a_fixed_ring_stands_off_its_rim_and_ground() -> None:
    """On the ring's circle a C is crossed by it, and reads G; on the ground it is hatched."""
    made, _, reading, view = inked("C7")
    radius = float(reading[made.end.lengths["3"]][0, 0])
    spots = [label for label in view.labels if label.text == "C"]
    near = min(spots, key=lambda one: abs(one.at - 1j * radius))
    ring = shapely.Point(0.0, 0.0)
    ring = ring.buffer(radius + RIM + HATCH_DEPTH, 64).difference(ring.buffer(radius, 64))
    assert box(near).distance(ring) > 0.3
    assert abs(near.at - 1j * radius) < 10.0
    assert box(near).distance(shapely.Point(0.0, radius)) < 12.0
    assert all(box(near).disjoint(shape(s)) for s in view.strokes)


@pytest.mark.parametrize("name", ["C7", "ring, five", "external-internal"])
def test_the_ground_of_a_fixed_ring_stands_on_its_rim_all_around(name: str) -> None:
    made, _, reading, view = inked(name)
    radius = float(reading[made.end.lengths[made.train.scheme.wheels[-1]]][0, 0]) + RIM
    ground = [s for s in view.strokes if s.part == "hatching" and isinstance(s, Stroke)]
    roots, tips = ([complex(*s.path[k][:2]) for s in ground] for k in (0, 1))
    assert np.allclose(np.abs(roots), radius, atol=1e-9)
    assert min(map(abs, tips)) > radius + 1.0
    gaps = np.diff(np.sort(np.angle(roots)))
    assert np.allclose(gaps, 2 * np.pi / len(ground), atol=1e-9)
    assert radius * gaps.max() < 4.0


@pytest.mark.parametrize("name", [name for name in ORDERS if "behind" in name])
def test_the_pair_behind_the_train_is_in_its_scheme(name: str) -> None:
    """Its wheels touch, are as large as their teeth say, and the first stands on the driven shaft."""
    made, _, reading, view = inked(name)
    mu, scheme = float(reading[made.mu][0, 0]), made.train.scheme
    x = float(reading[made.pairs.outside[0].stations[0]][0, 0])
    boxes = [shape(s).bounds for s in view.strokes if s.part == "wheel" and s.pen == "main"
             and isinstance(s, Stroke) and s.closed and abs(shape(s).centroid.x - x) < 1e-9]  # fmt: skip
    first, other = sorted(boxes, key=lambda sides: -sides[3])
    assert first[3] - first[1] == pytest.approx(15 * made.order.module / mu)
    assert other[3] - other[1] == pytest.approx(25 * made.order.module / mu)
    assert first[1] == pytest.approx(other[3])
    assert first[1] + first[3] == pytest.approx(0.0, abs=1e-9)
    row = complex(reading[made.axial.discs["1"].centre][0, 0]).real
    assert (x > row) == (made.order.driving == "1")
    shafts = [(a.real, b.real) for a, b in lines(view, "main") if a.imag == b.imag == 0.0]
    assert any(min(ends) < x < max(ends) for ends in shafts)
    names = [label for label in view.labels if box(label).distance(shapely.Point(x, 0.0)) < 80.0]
    due = {str(len(scheme.wheels) + 1), str(len(scheme.wheels) + 2)}
    assert due <= {label.text for label in names}


def test_what_was_read_can_be_read_off_the_sheet() -> None:
    made, _, reading, view = inked("C7")
    told = [dict(s.data) for s in view.strokes if s.data]
    assert {t["segment"] for t in told} == {"Aa", "Bb", "s_1", "s_2", "s_H"}
    (one,) = (t for t in told if t["segment"] == "s_1")
    assert float(one["value"]) == pytest.approx(302.4, rel=1e-5)
    page = svg(Sheet("s", "s", "A1", 841.0, 594.0, (view.moved(150 + 200j),)))
    assert page == svg(Sheet("s", "s", "A1", 841.0, 594.0, (view.moved(150 + 200j),)))
    assert float(reading[made.mu][0, 0]) == 0.005


@each("language", ["ru", "en"])
@each("name", ORDERS)
def test_tables_are_those_of_the_log(name: str, language: str) -> None:
    made, log, reading, _ = inked(name)
    conditions = condition_table(log, reading, made, language, WALL)
    texts = [label.text for label in conditions.labels]
    assert sum("a_w =" in text or "a′_w =" in text for text in texts) == 2
    rates = rate_table(log, reading, made, language, WALL)
    assert {"s_1", "s_2", "s_H"} <= {label.text for label in rates.labels}
    trains = train_table(search(made.order), language, WALL)
    assert "k" in {label.text for label in trains.labels}
    *willis, measured, difference = ratio_lines(log, reading, made, language)
    assert "s_1" in measured
    assert difference.endswith("0,00 %" if language == "ru" else "0.00 %")
    for text in (*willis, measured, difference, *texts):
        assert letter(text).parts


def test_the_table_of_the_windrower() -> None:
    made, log, reading, _ = inked("C7")
    texts = [label.text for label in condition_table(log, reading, made, "ru", WALL).labels]
    assert "N = (z_1 + z_3)/k = (25 + 89)/3 = 38 – целое" in texts
    assert "a′_w = m·(z_3 − z_2)/2 = 0,008·(89 − 32)/2 = 0,228 м = a_w" in texts
    rows = [label.text for label in train_table(search(C7), "ru", WALL).labels]
    assert {"25", "32", "89", "4,560", "732,0"} <= set(rows)


def test_a_ruler_shows_its_difference() -> None:
    draft = Draft()
    made = draw_planetary(draft, C7)
    log = draft.board.construction()
    reading = execute(log, draft.given, hand=Hand(0.5))
    assert ratio_lines(log, reading, made, "en")[2].endswith("= 0.35 %")  # 75.5/16.5 = 4.576
