"""The tables of a scene: columns along the positions, results, scale factors; of many drawings too."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Drawn, DrawnScene, Results, hand_of, single
from graphic_tmm.fitting.scales import scale_keys
from graphic_tmm.language.numbers import decimals_of
from graphic_tmm.language.units import unit_name
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.columns import Column, Positions, Tabled
from graphic_tmm.readers.position_count import Finer, finer
from graphic_tmm.readers.spread import ATTEMPTS, Spread
from graphic_tmm.readers.text import left_out, result_tables, text_tables
from graphic_tmm.readers.writing import as_csv, as_json
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.studio import blocks

WIDTH = 220
"""Characters of a line of text without a terminal."""


def columns_of(drawn: Drawn) -> list[Column]:
    """Return the columns of a board; null where a position cannot be drawn."""
    project = drawn.project
    found = chain.from_iterable(Tabled.of(one).columns(drawn) for one in project.chapters)
    language = drawn.scene.language
    units = (replace(column, unit=unit_name(column.unit, language)) for column in found)
    return [column.without(drawn.undrawn) for column in units]


def results_of(drawn: Drawn) -> Results:
    """Return the results of a board."""
    found: dict[str, tuple[Reals, str]] = {}
    for chapter in drawn.project.chapters:
        found |= Tabled.of(chapter).results(drawn)
    language = drawn.scene.language
    return {name: (figures, unit_name(of, language)) for name, (figures, of) in found.items()}


def scene_columns(made: DrawnScene) -> list[Column]:
    """Return the columns of a scene: of its mechanism and of its parts, which have positions of their own."""
    return [column for drawn in made.boards for column in columns_of(drawn)]


def scene_results(made: DrawnScene) -> Results:
    """Return the results of a scene."""
    found: dict[str, tuple[Reals, str]] = {}
    for drawn in made.boards:
        found |= results_of(drawn)
    return found


def table(
    made: DrawnScene, form: str, trials: int = 1, *, width: int = WIDTH, comma: bool = False
) -> str | list[Any]:
    """Return the tables of a scene as CSV or JSON text, or framed for ``form`` "text".

    ``width``: the characters that a line of text has; ``comma``: CSV with decimal commas. ``trials``:
    how often the scene's hand draws everything; more than once, each figure is followed by the median and the
    5th and 95th hundredths of them.
    """
    scene = made.scene
    found, numbers = scene_columns(made), scene_results(made)
    if trials > 1:
        spread = _spread(made, found, numbers, trials)
        found, numbers = list(spread.columns()), spread.results()
    told = single(numbers)
    positions, sweep = positions_of(made), sweep_of(made)
    if form == "csv":
        division = None if made.exact else made.division
        return as_csv(positions, found, division, comma=comma, language=scene.language, sweep=sweep)
    if form == "text":
        decimals = 3 if made.exact else decimals_of(made.division)
        tables = text_tables(found, positions, scene.language, scene.title, decimals, width)
        results_ = result_tables(told, fine_results(made), scene.language, scene.title)
        return [*tables, *results_, *left_out(scene.left_out, scene.language, scene.title)]
    results, fine = facts_of(made), fine_results(made)
    for name, (value, of) in told.items():
        if math.isfinite(value):
            results[name] = {"value": value, "unit": of, **_divided(name, fine.get(name))}
    if scene.left_out:
        results["left_out"] = {name: str(says) for name, says in scene.left_out.items()}
    return as_json(scene_name(scene.source), scales_of(made), positions, found, results, sweep)


def fine_results(made: DrawnScene) -> dict[str, Finer]:
    """Return the finer rows of results of curves, by result."""
    found = (finer(drawn) for drawn in made.boards)
    return {name: one for one in found if one is not None for name in one.due}


def _divided(name: str, fine: Finer | None) -> dict[str, float]:
    """Return the cost of the number of positions for machines: the true value, the error of the result."""
    if fine is None:
        return {}
    # the finer row is summed in another order now and then: what rounding leaves is no difference
    told = {
        "due": float(f"{fine.due[name][0]:.9g}"),
        "off_percent": round(100.0 * fine.off[name], 4),
    }
    far = name in fine.far and fine.enough is not None
    return {**told, "positions": fine.enough} if far else told  # type: ignore[dict-item]


def _spread(made: DrawnScene, columns: list[Column], results: Results, trials: int) -> Spread:
    """Return how figures scatter when the scene's hand draws them so often; a block is held at a time."""
    for sure in ATTEMPTS:
        spread = Spread(columns, results, trials, sure)
        for one in blocks(made, hand_of(made.scene, trials)):
            spread.add(scene_columns(one), scene_results(one), one.trials)
            del one  # lest it be held while the next is drawn
        if not spread.missed:
            break
    return spread


def scales_of(made: DrawnScene) -> dict[str, Any]:
    """Return the scale factors under the names that machines read."""
    found = {}
    for drawn in made.boards:
        keys = scale_keys(drawn.project)
        for view, scale in drawn.scales.items():
            of = unit_name(scale.unit, made.scene.language)
            own = {drawn.names[k]: value for k, value in scale.own}
            found[keys.get(view, _plain_key(view))] = {
                "value": scale.value,
                "unit": of,
                **({"positions": own} if own else {}),
            }
        found |= dict(_bases(drawn))
    return found


def _bases(drawn: Drawn) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the scale factors of bases that were calculated and are no view's own, under the same names."""
    own = {view.scale for view in drawn.construction.views}
    for step in drawn.construction.steps:
        letter = BASES.get(step.it.name)
        told = letter and step.it.unit.endswith("/mm") and step.it in drawn.reading
        if told and step.it not in own:
            view = step.it.view.removesuffix("-calculation").replace(" ", "_").replace("-", "_")
            value = float(drawn.reading[step.it].ravel()[0])
            if math.isfinite(value):
                of = unit_name(step.it.unit, drawn.scene.language)
                yield f"mu_{letter}_{view}", {"value": value, "unit": of}


BASES = {"μ_φ": "phi", "μ_S": "S"}
"""Scale factors of bases, as machines read them."""


def _plain_key(view: str) -> str:
    return "mu_" + view.replace(" ", "_").replace("-", "_")


def positions_of(made: DrawnScene) -> Positions:
    """Return the positions of a scene: those of the first board that moves; none of wheels alone."""
    drawn = _first_moving(made)
    return () if drawn is None else tuple(zip(drawn.names, drawn.project.coordinates, strict=True))


def sweep_of(made: DrawnScene) -> Sweep | None:
    """Return what the drive of these positions goes through; None where no drive of a mechanism does."""
    drawn = _first_moving(made)
    return None if drawn is None else drawn.project.sweep


def _first_moving(made: DrawnScene) -> Drawn | None:
    for drawn in made.boards:
        if drawn.board == MECHANISM or any(at is not None for at in drawn.project.coordinates):
            return drawn
    return None


def facts_of(made: DrawnScene) -> dict[str, Any]:
    """Return the facts of a scene that are no results: its mobility W, its formula."""
    found: dict[str, Any] = {}
    for drawn in made.boards:
        for chapter in drawn.project.chapters:
            found |= Tabled.of(chapter).facts(drawn)
    return found


def trial_figures(made: DrawnScene, trials: int) -> tuple[list[Column], Results]:
    """Return the columns and the results of a drawing, or of as many as the scene's hand makes.

    ``mm``, ``value`` of a column: (trial, position), results (trial,); one trial where all drawings are alike,
    NaN where one of them has none. All are kept; a table of many drawings needs less (`spread`).
    """
    if trials == 1:
        return scene_columns(made), scene_results(made)
    columns, results = [], []
    for one in blocks(made, hand_of(made.scene, trials)):
        columns.append((one.trials, scene_columns(one)))
        results.append((one.trials, scene_results(one)))
        del one  # lest it be held while the next is drawn
    return joined_columns(columns), joined_results(results)


def joined_columns(blocks: Sequence[tuple[int, Sequence[Column]]]) -> list[Column]:
    """Return the columns of blocks of drawings, each with its number of trials, joined."""
    trials = [n for n, _ in blocks]
    found = []
    for first, *others in zip(*(columns for _, columns in blocks), strict=True):
        same = first, *(column.placed_as(first) for column in others)
        mm, value = (
            _joined(rows, trials) for rows in zip(*((c.mm, c.value) for c in same), strict=True)
        )
        found.append(replace(first, mm=mm, value=value))
    return found


def joined_results(blocks: Sequence[tuple[int, Results]]) -> Results:
    """Return the results of blocks of drawings, each with its number of trials, joined."""
    trials, nothing = [n for n, _ in blocks], np.full(1, np.nan)
    units = {name: unit for _, some in blocks for name, (_, unit) in some.items()}
    rows = {name: [some.get(name, (nothing,))[0] for _, some in blocks] for name in units}
    return {name: (_joined(rows[name], trials), unit) for name, unit in units.items()}


def _joined(blocks: Sequence[Reals], trials: Sequence[int]) -> Reals:
    """Return rows of blocks one below the other; a single one where nothing varies."""
    first = blocks[0]
    if len(first) == 1 and all(np.array_equal(rows, first, equal_nan=True) for rows in blocks):
        return first
    pairs = zip(blocks, trials, strict=True)
    return np.concatenate([np.broadcast_to(rows, (n, *rows.shape[1:])) for rows, n in pairs])
