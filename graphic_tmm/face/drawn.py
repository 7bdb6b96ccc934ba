"""The second verb: a scene drawn by a hand, of which nothing is laid out until somebody asks for it."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from graphic_tmm.board.hand import HANDS, HandName
from graphic_tmm.errors import AbsentError, SceneError, SheetError, TmmError
from graphic_tmm.face.html import rendered
from graphic_tmm.face.reading import Source, read
from graphic_tmm.face.refusals import Named, absent, refuse_out_of_range
from graphic_tmm.face.sheets import Sheet
from graphic_tmm.face.steps import Steps, steps_of
from graphic_tmm.face.tables import Quantity, Table
from graphic_tmm.face.work import Work
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import all_warnings
from graphic_tmm.readers.protocol import plan_protocols, plans
from graphic_tmm.readers.table import facts_of, scales_of
from graphic_tmm.scene.build import drawn_by
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from graphic_tmm.face.checks import Check, Judge, Readings, Way

MOST = 100_000
"""So often a hand draws at the most."""


def draw(
    scene: Source = None,
    *,
    hand: HandName | None = None,
    seed: int | None = None,
    trials: int = 1,
    exact: bool = False,
) -> Drawn:
    """Draw a scene.

    Parameters
    ----------
    scene : Scene, or what `read` takes
        What is drawn; left out, the scene that the commands draw by default.
    hand : str, optional
        Who draws, with his own ruler: "exact", "cad", "careful" or "student"; left out, the scene's.
    seed : int, optional
        Which of the hand's drawings, 0 ... 2³¹; left out, the scene's.
    trials : int
        How often the hand draws everything, 1 ... 100000: tables and results then hold them all.
    exact : bool
        By a hand that never slips, read without the ruler's rounding.

    Returns
    -------
    Drawn
        Its figures are found when the first of them is asked for, its sheets laid out when these are.

    Raises
    ------
    SceneError
        If the scene cannot be read.
    AbsentError
        If there is no such hand.
    SheetError
        If ``seed`` or ``trials`` is out of its range, or an exact drawing is to be drawn several times.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> drawn = tmm.draw("crank-rocker", hand="student", seed=7)
    >>> drawn.tables
    ('velocities', 'accelerations')
    """
    if hand is not None and hand not in HANDS:
        raise absent(hand, HANDS)
    refuse_out_of_range("seed", seed or 0, 0, 2**31)
    refuse_out_of_range("trials", trials, 1, MOST)
    if exact and trials > 1:
        raise SheetError(said("an exact drawing is the same each time: leave out trials, or exact"))
    return Drawn(drawn_by(read(scene), hand, seed), trials=trials, exact=exact)


class Drawn:
    """A scene as drawn, see `draw`: figures, sentences, sheets, and what is judged by it.

    Parameters
    ----------
    scene : Scene
        With the hand that draws it.
    trials : int
        How often it is drawn.
    exact : bool
        Read without the ruler's rounding, by a hand that never slips.
    """

    def __init__(self, scene: Scene, *, trials: int = 1, exact: bool = False) -> None:
        self._work = Work(scene, trials, exact)

    @property
    def scene(self) -> Scene:
        """The scene, with the hand that draws it."""
        return self._work.scene

    @property
    def trials(self) -> int:
        """How often it is drawn."""
        return self._work.trials

    @property
    def tables(self) -> tuple[str, ...]:
        """The names of the tables that there are: of the plans of the scene."""
        return tuple(dict.fromkeys(one.plan for one in self._work.figures[0]))

    def table(self, plan: str) -> Table:
        """Return the table of a plan.

        Parameters
        ----------
        plan : str
            Its name, as in `tables`: "velocities", "accelerations", "forces", "diagrams" ...

        Returns
        -------
        Table
            Arrays (trial, position) of mm and SI, by segments.

        Raises
        ------
        AbsentError
            If there is none of that name.
        """
        if plan not in self.tables:
            raise absent(plan, self.tables)
        return self._work.table(plan)

    @property
    def results(self) -> Mapping[str, Quantity]:
        """What comes out of it as one figure each, by name: ``results["J_fly"]``, a number with its unit; W.

        Of several drawings it is the first one's; all of them: ``results["J_fly"].trials``. What could not be
        drawn is not there.
        """
        return self._work.results

    @property
    def facts(self) -> Mapping[str, str]:
        """Further facts in words, by name: its ``formula`` by Assur groups."""
        told = facts_of(self._work.drawn_scene).items()
        return Named({name: one for name, one in told if isinstance(one, str)})

    @property
    def scales(self) -> Mapping[str, Quantity]:
        """The scale factors by name: ``scales["mu_velocities"]``, in SI units per mm."""
        found = scales_of(self._work.drawn_scene).items()
        return Named({name: Quantity(one["value"], one["unit"]) for name, one in found})

    @property
    def warnings(self) -> tuple[str, ...]:
        """What of it comes to nothing, could not be drawn, or is in doubt: a sentence each."""
        return all_warnings(self._work.drawn_scene, self.scene.language)

    def steps(
        self, plan: str = "all", position: str | int | None = None, *, why: bool = False
    ) -> Steps:
        """Return the protocol of a plan in one position: what a student does, with the figures.

        Parameters
        ----------
        plan : str
            Its name, "scales" or "synthesis", or "all".
        position : str or int, optional
            Its number, as on the sheet; left out, the first in which the plan is drawn.
        why : bool
            Print why each step is done, too; the records always tell.

        Returns
        -------
        Steps
            Records, one a step; printed, the text of ``graphic-tmm steps``.

        Raises
        ------
        AbsentError
            If there is no plan of that name, the scene does not have it, or no such position.
        SceneError
            If the plan is not drawn in that position: the key of the scene that lets it be.
        """
        if plan != "all" and plan not in plans():
            raise absent(plan, ("all", *plans()))
        language = self.scene.language
        wanted = plans() if plan == "all" else (plan,)
        at = None if position is None else str(position)
        try:
            found = plan_protocols(self._work.drawn_scene, wanted, at, language)
        except SceneError as error:
            if error.faults[0].key.startswith("--"):  # an option of the command, here a parameter
                raise AbsentError(error.faults[0].message) from None
            raise
        return steps_of(found, language, why=why)

    @property
    def sheets(self) -> tuple[Sheet, ...]:
        """The sheets, laid out as ``graphic-tmm draw`` does; of several drawings those of the first."""
        return tuple(map(Sheet, self._work.composed[1].sheets))

    def save(self, path: str | os.PathLike[str]) -> tuple[Path, ...]:
        """Write what is drawn into files.

        Parameters
        ----------
        path : str or path
            Its end tells what: ``.html`` the teaching page, ``.pdf`` all sheets in one file, ``.svg``,
            ``.png``, ``.dxf`` the sheets, numbered if there are several: ``x-1.svg``.

        Returns
        -------
        tuple of Path
            The files.

        Raises
        ------
        SheetError
            If nothing is saved so, a view fits no sheet, a package is missing, or a file cannot be written.
        """
        return self._work.save(Path(path))

    def note(self, path: str | os.PathLike[str]) -> tuple[Path, ...]:
        """Write the explanatory note (extra ``note``).

        Parameters
        ----------
        path : str or path
            Its end tells the format: ``.pdf``, ``.docx``, ``.html``, ``.md``.

        Returns
        -------
        tuple of Path
            The files: of Markdown its pictures too.

        Raises
        ------
        SheetError
            If notes are not written so, a package is missing, or a file cannot be written.
        """
        return self._work.note(Path(path))

    def check(
        self,
        readings: Readings,
        *,
        hand: Judge = "student",
        points: Way = "paper",
        trials: int = 400,
        doubtful: float = 0.97,
        wrong: float = 5.0,
    ) -> Check:
        """Hold readings of a drawing made by hand against the exact one.

        Parameters
        ----------
        readings : str, path, bytes, records or data frame
            A CSV file or a workbook; the text of one; records (or columns) with plan, position, segment and mm,
            or value and unit, or x and y (mm), as a list of dictionaries, a dictionary of lists, or a data
            frame of pandas.
        hand : str
            By whose drawings they are judged: "cad", "careful" or "student".
        points : str
            How x and y were read: off the "paper", the "screen" (0.1 mm) or a "photo" (0.5 mm).
        trials : int
            How often the hand draws to tell what is usual, 20 ... 100000.
        doubtful : float
            Beyond this quantile of the hand's own deviations a reading is doubtful, 0.5 ... 1.
        wrong : float
            Beyond so many times their root mean square, and beyond them all, it is wrong, 1 ... 100.

        Returns
        -------
        Check
            Verdicts and likely mistakes, as ``graphic-tmm check`` prints them.

        Raises
        ------
        SceneError
            If the readings cannot be read, or name what the scene does not have.
        AbsentError
            If there is no such hand.
        SheetError
            If a number is out of its range.
        """
        from graphic_tmm.face.checks import Check, judges, taken_of

        judges(hand, points, trials, doubtful, wrong)
        taken, source = taken_of(readings)
        checker = self._work.checker(hand, points, trials, doubtful, wrong)
        return Check(checker.of(taken, source).report)

    def plot(
        self, plan: str, segments: Sequence[str] | None = None, *, ax: Axes | None = None
    ) -> list[Axes]:
        """Draw a table as curves over the angle of the crank, or over what slides, by matplotlib.

        Parameters
        ----------
        plan : str
            The name of the table.
        segments : sequence of str, optional
            Those of it that are wanted; left out, all.
        ax : matplotlib.axes.Axes, optional
            Where to draw; left out, a new figure in which each unit has axes of its own.

        Returns
        -------
        list of matplotlib.axes.Axes
            One for each unit. Of several drawings the curve is their median, with a band that holds nine of
            ten.

        Raises
        ------
        AbsentError
            If there is no such table, or no such segment in it.
        SheetError
            If ``ax`` is to show several units.
        MissingError
            If matplotlib is not installed.
        """
        from graphic_tmm.face.plots import plotted

        return plotted(self.table(plan), segments, ax, self.scene.language)

    def _repr_html_(self) -> str:
        """Return the first sheet for a notebook, and how many more there are; why there is none."""
        _ = speaking(self.scene.language)
        try:
            sheets = self.sheets
        except TmmError as error:
            return rendered(
                "said.html", title=self.scene.title, lines=error.in_language(_).splitlines()
            )
        more = _("and {n} more: .sheets", n=len(sheets) - 1) if len(sheets) > 1 else ""
        return sheets[0]._repr_html_() + rendered("said.html", title="", lines=[more])

    def __repr__(self) -> str:
        scene = self.scene
        hand = "exact" if self._work.exact else f"{scene.hand}, seed {scene.seed}"
        many = f", {self.trials} trials" if self.trials > 1 else ""
        return f"<Drawn {scene.title!r} by hand {hand}{many}>"
