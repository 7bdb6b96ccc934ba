"""The driving link and the groups by themselves: nothing left out, nothing twice, mobility that adds up."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
import shapely
from support.gallery import SHEETS
from support.mechanisms import sample

from graphic_tmm.chapters.structure import PARTS
from graphic_tmm.chapters.structure.record import MOBILITY, STRUCTURE_PLAN
from graphic_tmm.chapters.structure.table import structure_lines
from graphic_tmm.chapters.structure.views import part_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.mechanism.records import Row
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.shapes import shape
from graphic_tmm.project import record
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

pytestmark = pytest.mark.every

ORDER = (SheetOrder("A1", (PARTS,)),)
SOME = ("windrower", "lever", "oscillating-cylinder", "scotch-yoke")


def scenes(count: int) -> list[Drawn]:
    """Mechanisms drawn by chance."""
    made = sample(count, 7)
    return [
        fitted(Scene("", "T", "ru", one.mechanism, Row(6, zero=one.phi), sheets=ORDER))
        for one in made
    ]


def assert_parts(work: Drawn) -> None:
    mechanism = work.scene.mechanism
    assert mechanism is not None
    made = MOBILITY.on(work)
    w = {name: work.reading[mark].item() for name, mark in made.parts.items()}
    numbers = [int(k) for name in w for k in name.split("-")]
    assert sorted(numbers) == sorted(link.number for link in mechanism.links)
    # letters counted by hand: one on k links is k − 1 turning pairs; a slide is one pair
    bodies = (*mechanism.links, mechanism.frame)
    letters = [letter for body in bodies for letter in body.points]
    pairs = len(letters) - len(set(letters)) + sum(len(body.slides) for body in bodies)
    assert (
        work.reading[made.whole].item() == 3 * len(mechanism.links) - 2 * pairs == sum(w.values())
    )
    views = part_views(work, True)
    assert len(views) == len(w)
    for view, name in zip(views, w, strict=True):
        texts = [label.text for label in view.labels]
        assert set(name.split("-")) <= set(texts), texts
        for link in (mechanism.by_number[int(k)] for k in name.split("-")):
            told = {letter for text in texts for letter in re.split(r"[ ,]+", text)}
            shared = {letter for letter in link.points if letters.count(letter) > 1}
            assert {re.sub(r"(\d+)$", r"_{\1}", letter) for letter in shared} <= told
        assert all(stroke.of for stroke in view.strokes)


@pytest.mark.parametrize(
    "name", [n if n in SOME[:1] else pytest.param(n, marks=pytest.mark.slow) for n in SOME]
)
def test_parts_of_scenes(name: str) -> None:
    scene = read(SHEETS / name)
    assert_parts(fitted(replace(scene, sheets=ORDER)))


def test_a_scene_that_shows_no_structure_records_no_step_of_it() -> None:
    scene = replace(read(SHEETS / "lever"), sheets=(SheetOrder("A1", ("positions",)),))
    assert MOBILITY.of(record(scene)) is None


@pytest.mark.slow
def test_parts_of_mechanisms_that_are_not_ours() -> None:
    for work in scenes(12):
        assert_parts(work)


@pytest.mark.parametrize("name", ["tipper", "excavator"])
def test_a_group_with_a_driven_cylinder_is_in_one_piece(name: str) -> None:
    """Its rod joins the cylinder to the other link: what is drawn hangs together."""
    work = fitted(replace(read(SHEETS / name), sheets=ORDER))
    groups = [f"part-{group.name}" for group in STRUCTURE_PLAN.on(work).groups]
    views = [view for view in part_views(work, True) if view.name in groups]
    assert len(views) == len(groups)
    for view in views:
        ink = [shape(stroke).buffer(0.05) for stroke in view.strokes if stroke.part != "number"]
        assert shapely.get_num_geometries(shapely.union_all(ink)) == 1


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        (
            "swinging-screen",
            (
                "При ведущем звене 4 механизм II класса: I(4) → II(3-5) → II(1-2)",
                "При ведущем звене 5 механизм II класса: I(5) → II(3-4) → II(1-2)",
            ),
        ),
        (
            "landing-gear",
            (
                "Driven by link 1, it is of class II: I(1) → II(2-3) → II(4-5)",
                "Driven by link 3, it is of class II: I(3) → II(1-2) → II(4-5)",
            ),
        ),
        ("class-four", ("При ведущем звене 5 механизм III класса: I(5) → III(1-2-3-4)",)),
        ("windrower", ()),
    ],
)
def test_other_driving_links_stand_below_a_mechanism_of_a_higher_class(
    name: str, lines: tuple[str, ...]
) -> None:
    scene = read(SHEETS / name)
    assert scene.mechanism is not None
    structure = dissect(scene.mechanism)
    shown = structure_lines(scene.mechanism, structure, scene.language)
    assert tuple(line for line in shown if "I(" in line)[1:] == lines
