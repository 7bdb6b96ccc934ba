"""Rows of positions: one, two, three, a million; trials that fail; numpy's own errors raised."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.boards import drawn_of
from support.command import invoke
from support.drawn import board
from support.gallery import NAMES, SHEETS
from support.hard_judge import judge, right
from support.hard_mechanisms import four_bar, slider_crank

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Curve, arrays, undefined
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read

# a few positions


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("command", [["table", "-f", "json"], ["steps"], ["draw"]])
def test_one_two_or_three_positions(count: int, command: list[str], tmp_path: Path) -> None:
    """Plans need no row; what needs one (a diagram) refuses with what to do."""
    for name, due in (("crank-rocker", 0), ("offset-slider", 0), ("slider-diagrams", 2)):
        text = (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
        lines = [
            f"positions = {count}" if line.startswith("positions ") else line
            for line in text.split("\n")
            if not line.startswith(("accelerations", "extra"))
        ]
        path = tmp_path / f"{name}.toml"
        path.write_text("\n".join(lines), encoding="utf-8")
        out = ["-o", str(tmp_path / name)] if command == ["draw"] else []
        result = invoke(command[0], path, *command[1:], *out, "-l", "en")
        assert result.exit_code == due, result.output
        if due:
            assert "needs 4 positions at least" in result.stderr


@pytest.mark.parametrize("mechanism", [slider_crank(0.3, 0.64), four_bar(1.0, 2.5, 2.0, 3.0)])
def test_one_of_a_row_is_the_row_of_one(mechanism: Any) -> None:
    angles = np.array([[0.0, 33.0, 180.0]])
    sheet = board(mechanism)
    whole = sheet.read(angles)
    for k in range(3):
        for name, row in sheet.read(angles[:, k : k + 1]).items():
            for key, value in row.items():
                due = np.broadcast_to(whole[name][key], 3)[k]
                np.testing.assert_allclose(value, due, rtol=1e-13, atol=1e-13)


# a million positions


def test_a_million_positions() -> None:
    """Every one is drawn, and those looked at are right within their conditions."""
    mechanism = four_bar(1.0, 2.5, 2.0, 3.0)
    sheet = board(mechanism)
    angles = np.linspace(0.0, 360.0, 10**6, endpoint=False)[None, :]
    velocities, bodies = sheet.velocities, sheet.positions.bodies
    b, rate = bodies[3].marks["B"], velocities.rates[3]
    wanted = [b, rate, sheet.accelerations.rates[3]]
    reading = execute(sheet.log, sheet.given | {sheet.positions.row[0]: angles}, wanted)
    for mark in wanted:
        assert reading[mark].shape == (1, 10**6)
        assert np.isfinite(reading[mark]).all()
    for k in (0, 1, 333_333, 999_999):
        angle = float(angles[0, k])
        one = sheet.read([[angle]])
        for mark, value in ((b, one["r"]["B", 3]), (rate, one["omega"][3])):
            np.testing.assert_allclose(reading[mark][0, k], value[0], rtol=1e-13)
        assert right(judge(mechanism, angle))
    # the mean of a rate over a whole turn is none: a rocker comes back
    assert abs(reading[rate].mean()) <= 1e-12 * np.abs(reading[rate]).max()


# trials, some of which fail


def _rod(made: Drawn) -> tuple[Any, float]:
    """The rod's real length: its mark and its usual value."""
    log = made.project.construction
    rod = next(m for m in log.given if m.letter == "l_{AB}" and m.view == "positions")
    return rod, float(np.ravel(np.asarray(made.given[rod]))[0])


def _varied(made: Drawn, lengths: np.ndarray) -> dict[Any, Any]:
    """What was given to a work, the rod's length anew for every trial."""
    return dict(made.given) | {_rod(made)[0]: lengths[:, None]}


@pytest.mark.every
@pytest.mark.parametrize("name", ["slider-diagrams", "offset-slider"])
def test_a_trial_that_fails_leaves_the_others_what_they_were(name: str) -> None:
    made = drawn_of(read(SHEETS / name), exact=True)
    log = made.project.construction
    rod, usual = _rod(made)
    lengths = usual * np.array([1.0, 0.01, 1.01, 0.3, 0.99])
    given = _varied(made, lengths)
    wanted = [s.it for s in log.steps if s.op.reads or s.op.across]
    together = execute(log, given, wanted)
    for trial, length in enumerate(lengths):
        alone = execute(log, dict(made.given) | {rod: length}, wanted)
        for mark in wanted:
            if isinstance(alone[mark], Curve) and not np.isfinite(alone[mark].knots).all():
                continue
            for whole, one in zip(arrays(together[mark]), arrays(alone[mark]), strict=True):
                if isinstance(whole, bool):
                    continue
                row = whole[trial if whole.shape[0] > 1 else 0]
                np.testing.assert_allclose(row, one[0], rtol=1e-12, atol=1e-12)


def test_quantiles_of_the_trials_that_can_be_drawn_know_nothing_of_the_others() -> None:
    made = drawn_of(read(SHEETS / "offset-slider"), exact=True)
    log = made.project.construction
    _, usual = _rod(made)
    lengths = usual * (1.0 + 0.01 * np.random.default_rng(5).standard_normal(400))
    bad = np.arange(400) % 7 == 3
    given = _varied(made, np.where(bad, 0.01 * usual, lengths))
    fine = _varied(made, lengths[~bad])
    velocities = KINEMATICS_PLAN.on(made).velocities
    assert velocities is not None
    mark = velocities.readings[KINEMATICS_PLAN.on(made).positions.closings[0].legs[1].link]
    some, all_ = execute(log, given, [mark])[mark], execute(log, fine, [mark])[mark]
    assert np.isnan(some[bad]).any(axis=1).all()
    assert np.isfinite(some[~bad]).all()
    levels = [0.05, 0.5, 0.95]
    found = np.quantile(some[np.isfinite(some).all(axis=1)], levels, axis=0)
    np.testing.assert_array_equal(found, np.quantile(all_, levels, axis=0))


# numpy's own errors


STEADY = [n for n in NAMES if "[frame]" in (SHEETS / n / "scene.toml").read_text("utf-8")]


@pytest.mark.parametrize("name", STEADY)
def test_no_step_of_a_scene_that_can_be_drawn_makes_numpy_complain(name: str) -> None:
    """Divisions by zero, overflow and invalid operations are raised; the log runs step by step.

    Steps that leave something undefined on purpose, and say why, are those whose result is not finite.
    """
    made = drawn_of(read(SHEETS / name), exact=True)
    log, loud = made.project.construction, []
    values = {m: made.reading[m] for m in log.given if m in made.reading}
    for step in log.steps:
        if step.it not in made.reading or any(mark not in made.reading for mark in step.uses):
            continue
        uses = [values.get(mark, made.reading[mark]) for mark in step.uses]
        if any(not isinstance(v, Curve) and undefined(v).any() for v in uses):
            continue
        count = made.reading.positions
        if step.op.across:
            uses = [_spread(v, count) for v in uses]
        try:
            with np.errstate(all="raise", under="ignore"):
                step.op.run(*uses, **step.choice)
        except FloatingPointError as error:
            result = made.reading[step.it]
            if isinstance(result, Curve) or not undefined(result).any():
                loud.append((step.it.view, step.op.name, str(error)))
    assert loud == []


def _spread(value: Any, count: int) -> Any:
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*(_spread(v, count) for v in value))
    return np.broadcast_to(value, (value.shape[0], count))
