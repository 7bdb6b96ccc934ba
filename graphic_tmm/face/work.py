"""Results of a drawn scene, each computed once, on first use."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from graphic_tmm.drawn import DrawnScene, Results
from graphic_tmm.face import tables
from graphic_tmm.face.reading import refuse_unlettered
from graphic_tmm.face.refusals import Named
from graphic_tmm.face.sheets import WRITERS, ending, saved
from graphic_tmm.face.tables import Quantity
from graphic_tmm.files import write
from graphic_tmm.fitting.composition import Composition, composition_file, read_composition
from graphic_tmm.language.numbers import decimals_of
from graphic_tmm.language.symbols import plain
from graphic_tmm.mechanism.records import TURN, Sweep
from graphic_tmm.readers.columns import Column, Positions
from graphic_tmm.readers.table import facts_of, positions_of, sweep_of, trial_figures
from graphic_tmm.readers.text import column_name, table_rows
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets, make

if TYPE_CHECKING:
    from graphic_tmm.checking.check import Checker
    from graphic_tmm.fitting.compose import Composed


class Work:
    """A scene that is drawn so often; ``exact``: by a hand that never slips, read without rounding."""

    def __init__(self, scene: Scene, trials: int, exact: bool) -> None:
        self.scene, self.trials, self.exact = scene, trials, exact
        self._checkers: dict[tuple[object, ...], Checker] = {}

    def __getstate__(self) -> dict[str, Any]:
        """Return what another process needs: what was drawn is drawn again there."""
        asked = {"scene": self.scene, "trials": self.trials, "exact": self.exact}
        return {**asked, "_checkers": {}}

    @cached_property
    def given(self) -> Composition | None:
        """The composition stored next to the scene's file."""
        source = self.scene.source
        return read_composition(composition_file(source)) if Path(source).is_file() else None

    @cached_property
    def drawn_scene(self) -> DrawnScene:
        """The scene as drawn: of many drawings the first, on no sheet."""
        return make(self.scene, exact=self.exact, given=self.given)

    @cached_property
    def figures(self) -> tuple[Sequence[Column], Results]:
        """The columns and the results of all drawings."""
        return trial_figures(self.drawn_scene, self.trials)

    @cached_property
    def composed(self) -> tuple[DrawnScene, Composed]:
        """The scene as drawn on its sheets."""
        refuse_unlettered(self.scene)
        return composed_sheets(self._by_its_hand, self.given)

    @property
    def _by_its_hand(self) -> Scene:
        """The scene whose own hand draws so."""
        return replace(self.scene, hand="exact", ruler=None) if self.exact else self.scene

    def table(self, plan: str) -> tables.Table:
        """Return the table of a plan that there is."""
        usual, language = positions_of(self.drawn_scene), self.scene.language
        chosen = [one for one in self.figures[0] if one.plan == plan]
        decimals = 3 if self.drawn_scene.exact else decimals_of(self.drawn_scene.division)
        rows = tuple(
            tuple(map(tuple, table_rows(some, at, language, decimals)))
            for at, some in _by_positions(chosen, usual)
        )
        title = f"{self.scene.title}. {captions(language).get(plan, plan)}"
        sweep = sweep_of(self.drawn_scene) or TURN
        found = tuple(_column(one, usual, sweep, self.trials, language) for one in chosen)
        return tables.Table(plan, plain(title), found, rows)

    @cached_property
    def results(self) -> Named[Quantity]:
        """Single-valued results, calculated ones too; without those that no drawing has."""
        told = facts_of(self.drawn_scene).items()
        found = {name: Quantity(one) for name, one in told if isinstance(one, (int, float))}
        for name, (row, unit) in self.figures[1].items():
            if np.isfinite(row).any():
                found[name] = Quantity(float(row[0]), unit, np.broadcast_to(row, (self.trials,)))
        return Named(found)

    def save(self, file: Path) -> tuple[Path, ...]:
        """Write the sheets, or the page."""
        from graphic_tmm.page import FORMAT
        from graphic_tmm.page.page import page
        from graphic_tmm.paper.write.export import pdf

        form = ending(file, {**WRITERS, FORMAT: None})
        made, found = self.composed
        if form == FORMAT:
            return (saved(file, page(made, found.sheets)),)
        if form == "pdf":
            return (saved(file, pdf(found.sheets)),)
        several = len(found.sheets) > 1
        files = {
            f"{file.stem}-{k}{file.suffix}" if several else file.name: WRITERS[form](one)
            for k, one in enumerate(found.sheets, 1)
        }
        return write(file.parent, files)

    def note(self, file: Path) -> tuple[Path, ...]:
        """Write the explanatory note."""
        from graphic_tmm.note.formats import FORMATS, refuse_missing
        from graphic_tmm.note.note import note_files, wanted

        form = ending(file, dict.fromkeys(FORMATS))
        refuse_missing([form])
        refuse_unlettered(self.scene)
        made = make(self._by_its_hand, wanted=wanted(self.scene), given=self.given)
        return write(file.parent, note_files(made, file.stem, [form]))

    def checker(
        self, hand: str, points: str, trials: int, doubtful: float, wrong: float
    ) -> Checker:
        """Return what readings are judged by; the hand draws once for all that are judged alike."""
        from graphic_tmm.checking.check import Checker
        from graphic_tmm.checking.judging.scatter import Limits

        key = (hand, points, trials, doubtful, wrong)
        if key not in self._checkers:
            refuse_unlettered(self.scene)
            by: Mapping[str, Any] = {"hand": hand, "points": points, "trials": trials}
            limits = Limits(doubtful, wrong)
            self._checkers[key] = Checker(self.scene, **by, limits=limits, given=self.given)
        return self._checkers[key]


def _by_positions(
    columns: Sequence[Column], usual: Positions
) -> list[tuple[Positions, list[Column]]]:
    """Return columns with the positions along which they run, those of the same together."""
    found: dict[Positions, list[Column]] = {}
    for one in columns:
        found.setdefault(one.at or usual, []).append(one)
    return list(found.items())


def _column(
    one: Column, usual: Positions, sweep: Sweep, trials: int, language: str
) -> tables.Column:
    at, sweep = (one.at, TURN) if one.at else (usual, sweep)
    coordinates = np.array([np.nan if value is None else value for _, value in at], dtype=float)
    mm, value = (np.broadcast_to(rows, (trials, rows.shape[1])) for rows in (one.mm, one.value))
    name = plain(column_name(one, language))
    positions = tuple(number for number, _ in at)
    stands_for = plain(one.quantity)
    figures = (mm, value, positions, coordinates, stands_for, sweep)
    return tables.Column(one.segment, name, one.unit, *figures)
