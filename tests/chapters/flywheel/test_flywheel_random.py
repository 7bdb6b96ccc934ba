"""Flywheels of random machines: against a fine truth, against their own ink, in the room of their sheet."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.flywheels import at_positions, crank, graphs, scene_of, truth

import graphic_tmm as tmm
from graphic_tmm.board.hand import HANDS
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.flywheel.table import (
    flywheel_results,
)
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.readers.sentences import sentence
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import sheets

U = np.linspace(0.0, 1.0, 65)
RULER = 'ruler = "exact"'


def scene(folder: Path, seed: int, count: int = 12, **choice: str) -> Scene:
    file = folder / f"{seed}-{count}.toml"
    text = scene_of(crank(seed), count, more=choice.get("more", ""), format_=choice.get("on", "A1"))
    text = text.replace(RULER, choice.get("ruler", RULER))
    file.write_text(text, encoding="utf-8")
    return read(file)


def segment(made: Drawn) -> float:
    assert FLYWHEEL_PLAN.of(made) is not None
    return float(made.reading[FLYWHEEL_PLAN.on(made).segment][0, 0])


@cache
def rows(seed: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    return crank(seed)(np.arange(count) * 2 * np.pi / count)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("count", [12, 24])
def test_the_segment_is_what_the_curves_give(tmp_path: Path, seed: int, count: int) -> None:
    made = drawn_of(scene(tmp_path, seed, count), exact=True)
    found = segment(made) * made.scales["energy"].value
    # 400 samples to an arc miss its crest by 1/800² of the arc's bend at the most
    assert found == pytest.approx(np.ptp(graphs(*rows(seed, count)).own), rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(("seed", "count"), [(0, 12), (1, 24)])
def test_a_student_who_draws_it_finds_the_segment_every_time(
    tmp_path: Path, seed: int, count: int
) -> None:
    """His curves end beside the feet of their last ordinates: by a prick, by a lean of the square."""
    asked = scene(tmp_path, seed, count)
    found = tmm.draw(asked, hand="student", trials=200).results["cd"].trials
    exact = tmm.draw(asked, hand="exact").results["cd"].value
    assert np.isfinite(found).all()
    # the greatest of ordinates that scatter lies above the true one by less than they scatter
    assert abs(np.median(found) - exact) < found.std() + (HANDS["student"].ruler or 0.0)


def test_extremes_on_curves_and_areas_below_them_are_an_order_nearer_to_the_truth() -> None:
    """Sixty smooth machines: the error of 12 positions is a tenth of what points and middles leave."""
    errors: dict[int, list[tuple[float, float]]] = {12: [], 24: []}
    for seed in range(60):
        due = truth(crank(seed), 7200)
        for count, found in errors.items():
            row = rows(seed, count)
            ways = np.ptp(graphs(*row, parts=100).own), at_positions(*row)
            found.append((abs(ways[0] / due - 1), abs(ways[1] / due - 1)))
    ours, others = np.mean(errors[12], axis=0)
    assert ours < 0.1 * others
    assert np.max(errors[12], axis=0)[0] < 0.005
    # cubic arcs with exact slopes: the fourth order, up to where the sampling ends
    assert np.mean(errors[24], axis=0)[0] < ours / 8


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_at_120_positions_it_is_the_truth(tmp_path: Path, seed: int) -> None:
    made = drawn_of(scene(tmp_path, seed, 120), exact=True)
    assert segment(made) * made.scales["energy"].value == pytest.approx(
        truth(crank(seed)), rel=2e-5
    )


def inked(text: str) -> dict[str, np.ndarray]:
    """Every curve with a title on a sheet: (arc, sample), complex, mm of the sheet, y upwards."""
    found = {}
    for d, title in re.findall(r'<path d="(M[^"]*C[^"]*)"[^>]*>\s*<title>([^<]+)</title>', text):
        x = np.array([float(part) for part in re.findall(r"-?\d+(?:\.\d+)?", d)])
        p = x[0::2] - 1j * x[1::2]
        arcs = [p[k : k + 4] for k in range(0, p.size - 1, 3)]
        v = 1 - U
        found[title] = np.array(
            [v**3 * a + 3 * v**2 * U * b + 3 * v * U**2 * c + U**3 * e for a, b, c, e in arcs]
        )
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("seed", "ruler"), [(0, RULER), (3, 'ruler = "0.1 mm"'), (5, 'ruler = "0.5 mm"')]
)
def test_the_number_is_what_the_ink_shows(tmp_path: Path, seed: int, ruler: str) -> None:
    drawn, paper = sheets(scene(tmp_path, seed, ruler=ruler))
    assert drawn is not None
    assert drawn.mechanism is not None
    results = single(flywheel_results(drawn.mechanism))
    (text,) = [svg(sheet) for sheet in paper if "(f–f)" in svg(sheet)]
    curves = inked(text)
    own = curves["(f–f)"].imag
    # half the ruler's division, and the three decimals of the ink
    division = {"exact": 0.0, "0.1 mm": 0.1, "0.5 mm": 0.5}[ruler.split('"')[1]]
    assert np.ptp(own) == pytest.approx(results["cd"][0], abs=division / 2 + 0.01)
    for taut in ("(k–k)",):
        y = curves[taut].imag
        ends = y[:, [0, -1]]
        assert (y.max(axis=1) <= ends.max(axis=1) + 0.002).all()
        assert (y.min(axis=1) >= ends.min(axis=1) - 0.002).all()
    lost = np.abs(curves["(g–g)"].imag - curves["(l–l)"].imag - own)
    # all three stand on one axis; each reading is off by half a division
    assert np.ptp(curves["(g–g)"].imag - curves["(l–l)"].imag - own) <= 2 * division + 0.01
    assert np.isfinite(lost).all()
    assert f"<title>{results['cd'][0]:.4g}</title>" in text


def test_the_extremes_are_steps_with_a_sentence_in_both_languages(tmp_path: Path) -> None:
    made = drawn_of(scene(tmp_path, 1), exact=True)
    steps = {
        step.it.letter: step for step in made.project.construction.steps if step.it.view == "energy"
    }
    for letter, says, ru in (("c′", "highest", "высшую"), ("d′", "lowest", "низшую")):
        assert says in sentence(steps[letter], "en", made.reading, 0)
        assert ru in sentence(steps[letter], "ru", made.reading, 0)
        spot = made.reading[steps[letter].it][0, 0]
        knots = made.reading[steps["f"].it][0]
        assert np.abs(knots - spot).min() > 0.05  # it stands between positions


@pytest.mark.parametrize("seed", [0, 1, 4])
@pytest.mark.parametrize("on", ["A1", "A4"])
@pytest.mark.parametrize("constant", ["resisting", "driving"])
def test_graphs_use_the_room_of_their_format(
    tmp_path: Path, seed: int, on: str, constant: str
) -> None:
    """The scale next to the one chosen, at most 2 times finer, would not do."""
    made = drawn_of(scene(tmp_path, seed, on=on, more=f'constant = "{constant}"'), exact=True)
    log, room = made.project.construction, FORMATS[on].graph
    tall = {}
    for view in ("moment", "work", "energy"):
        spots = [
            made.reading[s.it].imag.ravel()
            for s in log.steps
            if s.it.view == view and s.op.name in ("lay_off", "succession", "arrival")
            and s.it.letter in "kAgflA_N"
        ]  # fmt: skip
        heights = np.concatenate(spots)
        tall[view] = max(heights.max(), 0.0) - min(heights.min(), 0.0)
    assert room / 2 - 1e-6 <= tall["moment"] <= room + 1e-6
    assert room / 2 - 1e-6 <= max(tall["work"], tall["energy"]) <= room + 1e-6


def test_a_pole_distance_that_is_given_is_taken(tmp_path: Path) -> None:
    own, told = (drawn_of(scene(tmp_path, 2, more=m), exact=True) for m in ("", 'H = "33 mm"'))
    mu = told.scales["moment"].value * 2 * np.pi / 180 * 33
    assert told.scales["work"].value == pytest.approx(mu)
    free = own.scales["work"].value
    assert float(f"{free:.0e}"[0]) in (1.0, 2.0, 4.0, 5.0) or f"{free:.1e}"[:3] == "2.5"
    one, other = (segment(made) * made.scales["energy"].value for made in (own, told))
    assert one == pytest.approx(other, rel=1e-9)
