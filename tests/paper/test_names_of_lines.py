"""A vector or curve among others is named beside itself: of triangles, and of flywheels drawn at random."""

from __future__ import annotations

import cmath
import math
import random
from pathlib import Path

import pytest
import shapely
from support.boards import drawn_of
from support.each import each
from support.flywheels import crank, scene_of
from support.gallery import drawn

from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Label, Wanted, line
from graphic_tmm.paper.labels import leaders, place
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.scene.read import read

WHEELS = ["windrower", "engine"]


def wedge(seed: int) -> dict[str, tuple[complex, complex]]:
    """A triangle P = Q + N, tip to tail, with a small angle between P and Q, in any direction."""
    rng = random.Random(seed)
    start = complex(rng.uniform(-40, 40), rng.uniform(-40, 40))
    whole = cmath.rect(rng.uniform(15, 60), rng.uniform(0, 2 * math.pi))
    turn = math.radians(rng.choice([-1, 1]) * rng.uniform(3, 14))
    along = whole / math.cos(turn) * cmath.exp(1j * turn)
    return {
        "P": (start, start + whole),
        "Q": (start, start + along),
        "N": (start + along, start + whole),
    }


@each("seed", range(60))
def test_the_letter_of_a_vector_is_nearest_to_its_own_or_led_there(seed: int) -> None:
    vectors = wedge(seed)
    wanted = []
    for name, own in vectors.items():
        others = tuple(other for key, other in vectors.items() if key != name)
        # on the side that was preferred of old: of one of P and Q that is inside the wedge
        way = 1j * (own[1] - own[0])
        wanted.append(Wanted(name, sum(own) / 2, 3.5, 0.8, way, line=own, others=others))
    strokes = [line("over", *own) for own in vectors.values()]
    labels = place(wanted, strokes)
    led = {label.text: leaders([one], [label]) for one, label in zip(wanted, labels, strict=True)}
    for label in labels:
        away = {name: box(label).distance(shapely.LineString([(z.real, z.imag) for z in own]))
                for name, own in vectors.items()}  # fmt: skip
        nearest = min(away.values())
        if not led[label.text]:
            assert away[label.text] <= nearest + 1e-6
        else:
            (leader,) = map(shape, led[label.text])
            for name, own in vectors.items():
                if name != label.text:
                    assert not leader.intersects(
                        shapely.LineString([(z.real, z.imag) for z in own])
                    )


def curves_of(work: Drawn, view: Drawing, label: Label) -> shapely.Geometry | None:
    """What is drawn of the curve that a label names by its mark or by that of the readings of its points."""
    steps = {step.it.slot: step for step in work.construction.steps}
    slots = set(label.of)
    for slot in label.of:
        if steps[slot].op.name == "measure_along":
            points = steps[slot].uses[1]
            slots |= {s.it.slot for s in steps.values() if s.uses and s.uses[0] == points}
    own = [shape(s) for s in view.strokes if slots & set(s.of) and s.pen == "main"]
    return shapely.union_all(own) if own else None


def assert_named_beside_their_own(work: Drawn, texts: set[str]) -> None:
    (view,) = [v for v in flywheel_views(work, True) if v.name == "flywheel-graphs"]
    named = [label for label in view.labels if label.of and label.text.split("_")[0] in texts]
    found = [(label, curve) for label in named if (curve := curves_of(work, view, label))]
    assert len(found) >= 4  # two works, and energies
    led = {stroke.of for stroke in view.strokes if stroke.part == "leader"}
    for label, own in found:
        away = box(label).distance(own)
        others = [box(label).distance(curve) for other, curve in found if other != label]
        assert label.of in led or away <= min(others) + 1e-6, label.text


@each("name", WHEELS)
def test_curves_of_the_scenes_are_named_beside_themselves(name: str) -> None:
    assert_named_beside_their_own(drawn(name, exact=True), {"A", "ΔT", "T"})


@pytest.mark.slow
@each("seed", range(8), turns=3)
def test_curves_of_flywheels_drawn_at_random_are_too(seed: int, tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    constant = ("driving", "resisting")[seed % 2]
    path.write_text(scene_of(crank(seed), 12, more=f'constant = "{constant}"'), encoding="utf-8")
    work = drawn_of(read(path), exact=True)
    assert_named_beside_their_own(work, {"A", "ΔT", "T"})
    letters = {label.text for view in flywheel_views(work, True) for label in view.labels}
    due = {"driving": {"M_d", "M_д"}, "resisting": {"M_c"}}
    assert letters & due[constant]
    assert not letters & due[("resisting", "driving")[seed % 2]]
    assert "P′" not in letters
