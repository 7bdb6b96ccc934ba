"""A flywheel by moments over a cycle: against numpy alone, in one turn, two and three."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.boards import in_usual_size, usual_part
from support.flywheels import along, graphs, taut
from support.graphs import assert_read_off_the_log
from support.scenes import written

from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.record import BESIDE
from graphic_tmm.chapters.cycle.table import cycle_results
from graphic_tmm.chapters.cycle.task import Moment
from graphic_tmm.chapters.cycle.views import cycle_views
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.labels import finished
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.scene.read import read

SAMPLED = 1e-6
"""400 samples an arc lie below its crest by 1/800² of an arc's bend at the most."""
HEAD = 'title = "T"\nlanguage = "en"\n'
SHEET = '[[sheet]]\nformat = "A2"\nplace = ["cycle", "cycle given"]\n'
STROKES = [(0, 0), (30, 600), (90, 300), (180, 0), (270, -40), (540, 0), (690, -200), (720, 0)]


def text_of(
    points: list[tuple[float, float]], turns: int, count: int, *, more: str = "delta = 0.02"
) -> str:
    listed = ", ".join(f'[{angle!r}, "{moment!r} N*m"]' for angle, moment in points)
    return (
        f'{HEAD}[cycle]\nspeed = "20 1/s"\nturns = {turns}\npositions = {count}\n{more}\n'
        f"[[moment]]\npoints = [{listed}]\n{SHEET}"
    )


def drawn_from(folder: Path, text: str) -> Drawn:
    return usual_part("cycle", read(written(folder, text)))


def results(made: Drawn) -> dict[str, float]:
    return {name: value for name, (value, _) in single(cycle_results(made)).items()}


def ordinates(points: list[tuple[float, float]], turns: int, count: int) -> np.ndarray:
    """At the positions, of a diagram without jumps that closes."""
    angles, moments = zip(*points, strict=True)
    return np.interp(np.arange(count) * 360.0 * turns / count, angles, moments)


@settings(max_examples=8, deadline=None)
@given(
    turns=st.integers(1, 3),
    count=st.sampled_from([8, 12, 24, 36]),
    moments=st.lists(st.integers(-90, 90), min_size=4, max_size=9),
    mode=st.sampled_from(["areas", "middles", "chords"]),
)
def test_any_moment_over_any_cycle_gives_what_numpy_integrates(
    turns: int, count: int, moments: list[int], mode: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """The work of one turn is that of ``graphs``; of several turns it is as many times as large."""
    moments[0] = 10 + abs(moments[0])  # something drives
    angles = np.linspace(0.0, 360.0 * turns, len(moments) + 1)
    points = [(float(a), float(m)) for a, m in zip(angles, [*moments, moments[0]], strict=True)]
    row = ordinates(points, turns, count)
    due = turns * float(np.ptp(graphs(row, np.zeros(count), mode).own))
    folder = tmp_path_factory.mktemp("cycle")
    text = text_of(points, turns, count, more=f'delta = 0.05\nintegration = "{mode}"')
    if due < 1e-9:
        return
    made = drawn_from(folder, text)
    assert results(made)["J_fly"] == pytest.approx(due / (0.05 * 20.0**2), rel=10 * SAMPLED)


def test_a_four_stroke_engine_has_the_mean_moment_and_power_of_its_area(tmp_path: Path) -> None:
    row = ordinates(STROKES, 2, 24)
    mean = float(np.mean(along(row, taut(row), 4000)))
    found = results(drawn_from(tmp_path, text_of(STROKES, 2, 24)))
    assert found["M_mean"] == pytest.approx(mean, rel=1e-6)
    assert found["power"] == pytest.approx(20.0 * mean, rel=1e-6)


def test_delta_of_a_given_inertia_is_the_way_back(tmp_path: Path) -> None:
    inertia = results(drawn_from(tmp_path, text_of(STROKES, 2, 24)))["J_fly"]
    back = drawn_from(tmp_path, text_of(STROKES, 2, 24, more=f'J = "{inertia!r} kg*m^2"'))
    assert results(back)["delta"] == pytest.approx(0.02, rel=1e-12)


def test_jumps_at_positions_keep_the_area_and_come_near_the_closed_form(tmp_path: Path) -> None:
    """M for a third of the cycle, then nothing: ΔT = M·φ·(1 − 1/3), short of half a step at the jumps."""
    points = [(0.0, 90.0), (120.0, 90.0), (120.0, 0.0), (360.0, 0.0)]
    found = results(
        drawn_from(tmp_path, text_of(points, 1, 180, more='delta = 0.1\nintegration = "chords"'))
    )
    assert found["M_mean"] == pytest.approx(30.0, rel=1e-9)
    closed = 90.0 * (2 * np.pi / 3) * (1 - 1 / 3) / (0.1 * 20.0**2)
    step = 2 * np.pi / 180
    assert found["J_fly"] == pytest.approx(closed, abs=90.0 * step / (0.1 * 20.0**2))
    assert found["J_fly"] != pytest.approx(closed, rel=1e-6)


def test_moments_add_up_and_a_jump_is_read_in_the_middle(tmp_path: Path) -> None:
    one = Moment(((0.0, 10.0), (90.0, 10.0), (90.0, 30.0), (360.0, 20.0)))
    assert [one.at(angle) for angle in (0.0, 45.0, 90.0, 225.0, 360.0)] == [15, 10, 20, 25, 15]
    text = text_of(STROKES, 2, 24)
    halves = text_of([(a, m / 2) for a, m in STROKES], 2, 24)
    twice = halves.replace(SHEET, "") + halves.split("delta = 0.02\n")[1]
    whole, parts = (results(drawn_from(tmp_path, one)) for one in (text, twice))
    assert parts == pytest.approx(whole)


def test_a_compressor_is_driven_by_a_constant_moment(tmp_path: Path) -> None:
    """Which of the two moments is constant changes the sign of ΔT, not its range."""
    drive, resist = (
        drawn_from(tmp_path, text_of(STROKES, 2, 24, more=f'delta = 0.02\nconstant = "{side}"'))
        for side in ("resisting", "driving")
    )
    assert results(resist)["J_fly"] == pytest.approx(results(drive)["J_fly"], rel=1e-9)
    one, other = (
        made.reading[CYCLE_PLAN.on(made).flywheel.charts[2].ordinates[0]]
        for made in (drive, resist)
    )
    np.testing.assert_allclose(
        one * drive.scales["energy"].value, -other * resist.scales["energy"].value, atol=1e-9
    )


def test_the_views_are_read_off_the_log_and_the_protocol_tells_the_turns(tmp_path: Path) -> None:
    made = drawn_from(tmp_path, text_of(STROKES, 2, 24, more='delta = 0.02\nD_e = "0.4 m"'))
    assert BESIDE.on(made).force is None
    views = [finished(one, lettered=False) for one in cycle_views(made, False)]
    assert {"cycle-graphs", "flywheel", "table-results"} <= {one.name for one in views}
    graph = next(one for one in views if one.name == "cycle-graphs")
    assert_read_off_the_log(made.construction, [graph])
    lines = "\n".join(protocol(made, ("cycle",), "3", "en"))
    assert "2π·n_t/L = 2π·2/" in lines


@pytest.mark.parametrize(
    ("edit", "key", "says"),
    [
        (('[720, "0', '[700, "0'), "moment 1, points", "from 0 to 720"),
        (("delta = 0.02", ""), "cycle.delta", "or J of the flywheel"),
        (("[[moment]]", "[moments]"), "cycle", "write [[moment]]"),
        (("turns = 2", "turns = 0"), "cycle.turns", "1 to 12"),
        (('[30, "600 N*m"]', '[-30, "600 N*m"]'), "moment 1, points", "in order"),
        (('[30, "600 N*m"]', "[30, 600, 1]"), "moment 1, points", "write points of the cycle"),
    ],
)
def test_what_does_not_fit_is_told(
    edit: tuple[str, str], key: str, says: str, tmp_path: Path
) -> None:
    text = text_of(STROKES, 2, 24)
    assert edit[0] in text
    with pytest.raises(SceneError) as refused:
        read(written(tmp_path, text.replace(*edit)))
    told = {fault.key: fault.message for fault in refused.value.faults}
    assert key in told, told
    assert says in told[key]


def test_a_scene_of_a_cycle_needs_no_mechanism(tmp_path: Path) -> None:
    made = in_usual_size(read(written(tmp_path, text_of(STROKES, 2, 24))))
    assert [one.board for one in made.boards] == ["cycle"]


def test_a_rim_that_is_a_drum_is_told_on_the_terminal_and_on_no_sheet(tmp_path: Path) -> None:
    more = 'delta = 0.02\nD_e = "0.9 m"'
    made = drawn_from(tmp_path, text_of([(0, 0), (90, 600), (720, 0)], 2, 24, more=more))
    assert [text for text in warnings(made) if "choose D_e" in text]
    labels = [label.text for view in cycle_views(made, True) for label in view.labels]
    assert "Sketch of the flywheel" in labels
    assert not [text for text in labels if "choose" in text]
