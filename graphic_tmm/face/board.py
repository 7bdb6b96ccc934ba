"""A construction of one's own: drawn step by step, then read as numbers, sentences and ink."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import examine
from graphic_tmm.board.hand import HANDS, HandName
from graphic_tmm.board.operations import formulas  # noqa: F401 - entered into the table by being read
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Complexes, Point, Reals
from graphic_tmm.drawn import MEASURED
from graphic_tmm.errors import ConstructionError, SheetError
from graphic_tmm.face.drafting import NUMBERS, Drafting
from graphic_tmm.face.picture import picture
from graphic_tmm.face.refusals import absent, refuse_out_of_range
from graphic_tmm.face.sheets import Sheet
from graphic_tmm.face.steps import Steps, steps_of
from graphic_tmm.face.tables import Quantity
from graphic_tmm.language.catalogue import languages, speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import spoken
from graphic_tmm.readers.findings import why_of
from graphic_tmm.readers.narration import protocol
from graphic_tmm.readers.protocol import PlanProtocol
from graphic_tmm.scene.captions import view_name
from graphic_tmm.scene.drawing import DIVISIONS


class Board(Drafting):
    """A drawing board: a construction of your own, written into the same log as every plan of the package.

    What is given (`point`, `length`, `angle`, `number`) and what the instruments draw (`join`, `parallel`,
    `strike`, `meet` ...) are marks: each method takes a letter first and returns the mark that it leaves.
    Then the log is read: `value` and `where` tell figures, `steps` what was done in words, `sheet` shows it.
    Lengths are mm on the sheet, angles degrees, x to the right and y up. A row of numbers instead of one gives
    as many positions, drawn at once.

    Parameters
    ----------
    hand : str
        Who draws: "exact", "cad", "careful" or "student", with his own ruler.
    seed : int
        Which of the hand's drawings, 0 ... 2³¹.
    trials : int
        How often the hand draws everything, 1 ... 100000.
    language : str
        Of sentences and letters: "en" or "ru".
    title : str
        What the picture is called, and the view that is open at first.

    Raises
    ------
    AbsentError
        If there is no such hand, or no such language.
    SheetError
        If a number is out of its range.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> board = tmm.Board()
    >>> O, C = board.point("O", 0, 0), board.point("C", 60, 0)
    >>> A = board.lay_off("A", board.ray("OA", O, 60), 20)
    >>> B = board.cross("B", board.strike("b", A, 55), board.strike("c", C, 40), +1)
    >>> board.link(O, A), board.link(A, B), board.link(B, C)
    (None, None, None)
    >>> board.value(board.measure("OB", O, B))
    72.1995 mm
    >>> print(board.steps()[1].text)
    On OA lay off 20 mm from its beginning; mark A.
    """

    def __init__(
        self,
        *,
        hand: HandName = "exact",
        seed: int = 0,
        trials: int = 1,
        language: str = "en",
        title: str = "Construction",
    ) -> None:
        for name, known in ((hand, tuple(HANDS)), (language, languages())):
            if name not in known:
                raise absent(name, known)
        refuse_out_of_range("seed", seed, 0, 2**31)
        refuse_out_of_range("trials", trials, 1, 100_000)
        ruler = None if hand == "exact" else DIVISIONS[hand]
        self._hand = HANDS[hand]._replace(ruler=ruler, seed=seed, trials=trials)
        self._language, self._title = language, title
        super().__init__(title)
        self._read: tuple[Construction, Reading] | None = None

    def array(self, mark: Mark) -> Reals | Complexes:
        """Return the figures of a mark in all drawings and positions.

        Parameters
        ----------
        mark : Mark
            A point, a length, an angle or a number.

        Returns
        -------
        array
            (trial, position): of a point x + iy, mm; of a length mm, of an angle degrees; NaN where it cannot
            be drawn.

        Raises
        ------
        ConstructionError
            If it is a line, an arc or a curve: these are no figures.
        """
        if mark.kind not in (Point, *NUMBERS):
            raise ConstructionError(
                said("'{letter}' is no figure: measure what it goes through", letter=mark.letter)
            )
        found: Reals | Complexes = np.broadcast_to(
            self._reading[1][mark], (self._hand.trials, self.positions)
        )
        return found

    def value(self, mark: Mark, position: int = 0) -> Quantity:
        """Return a length (mm), an angle (degrees) or a number with its unit.

        Parameters
        ----------
        mark : Mark
            What was measured, calculated or given.
        position : int
            Which of the positions, from 0.

        Returns
        -------
        Quantity
            NaN where it cannot be drawn; ``trials``: of every drawing.

        Raises
        ------
        ConstructionError
            If it is no figure.
        """
        if mark.kind is Point:
            says = said("'{letter}' is a point: where() tells its place", letter=mark.letter)
            raise ConstructionError(says)
        row = self.array(mark)[:, position].real
        return Quantity(float(row[0]), MEASURED.get(mark.kind, mark.unit), row)

    def where(self, point: Mark, position: int = 0) -> complex:
        """Return the place of a point: x + iy, mm.

        Parameters
        ----------
        point : Mark
            The point.
        position : int
            Which of the positions, from 0.

        Raises
        ------
        ConstructionError
            If it is no figure.
        """
        return complex(self.array(point)[0, position])

    def steps(self, position: int = 0, *, why: bool = False) -> Steps:
        """Return what was done, in words, view by view, with the figures.

        Parameters
        ----------
        position : int
            Which of the positions, from 0.
        why : bool
            Print why each step is done, too; the records always tell.
        """
        log, reading = self._reading
        doubted = reading.doubted(Doubts(log.steps, self._draft.given))
        told = []
        for view in dict.fromkeys(step.it.view for step in log.steps):
            lines = protocol(log, view, doubted, position, self._language)
            told.append(PlanProtocol(view_name(view, self._language), tuple(lines)))
        return steps_of(told, self._language, why=why)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What could not be drawn, or is in doubt: step, letter, why, positions from 0."""
        log, reading = self._reading
        marks = [step.it for step in log.steps if not step.op.across]
        found = examine(log, self._draft.given, marks, hand=self._hand, drawn=reading)
        speech = speaking(self._language)
        return tuple(
            speech(
                "{plan}, step {number} '{it}': {why}; positions {places}",
                plan=view_name(one.step.it.view, self._language),
                number=one.number,
                it=spoken(one.step.it, self._language),
                why=why_of(one, speech),
                places=", ".join(map(str, one.positions)),
            )
            for one in found
            if one.kind != "lost"
        )

    def sheet(self, *, helping: bool = True) -> Sheet:
        """Return the picture, true to the millimetre: of several drawings the first, all its positions.

        Parameters
        ----------
        helping : bool
            With lines and arcs that only helped, and are rubbed out at the end.

        Raises
        ------
        SheetError
            If nothing of it can be drawn.
        """
        log, reading = self._reading
        drawn = picture(log, reading.trial(0), self._title, self._language, helping=helping)
        return Sheet(drawn)

    def save(self, path: str | os.PathLike[str], *, helping: bool = True) -> Path:
        """Write the picture into a file.

        Parameters
        ----------
        path : str or path
            Its end tells the format: ``.svg``, ``.pdf``, ``.png``, ``.dxf``.
        helping : bool
            As for `sheet`.

        Returns
        -------
        Path
            The file.

        Raises
        ------
        SheetError
            As `sheet` and `Sheet.save`.
        """
        return self.sheet(helping=helping).save(path)

    def _repr_html_(self) -> str | None:
        """Return the picture for a notebook; None as long as there is none."""
        try:
            return self.sheet()._repr_html_()
        except SheetError:
            return None

    def __repr__(self) -> str:
        return f"<Board {self._title!r}: {len(self.construction.steps)} steps>"

    @property
    def _reading(self) -> tuple[Construction, Reading]:
        """The log and its numbers, computed again after something was drawn."""
        log = self.construction
        if self._read is None or self._read[0] != log:
            self._read = log, execute(log, self._draft.given, hand=self._hand)
        return self._read
