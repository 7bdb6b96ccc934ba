"""What checking speaks of: readings of a hand-made drawing, what is judged of them, likely mistakes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.paper.drawing import Drawing, Ink

FINE, DOUBTFUL, WRONG = "fine", "doubtful", "wrong"
VERDICTS = (FINE, DOUBTFUL, WRONG)


class Last(NamedTuple):
    """Half a unit of the last digit that was written of each figure, in its own unit; 0 where none is known."""

    mm: float = 0.0
    value: float = 0.0
    x: float = 0.0
    y: float = 0.0


class Taken(NamedTuple):
    """A reading as somebody took it: of a segment (mm on paper, or a quantity with its unit) or of a point.

    ``position`` is "" for a result of the whole project. ``mm``; ``value`` with ``unit``; ``x``, ``y`` (mm on
    the plan, from its pole): None where not given. ``line`` of the file it stands in; ``last``: how finely it
    was written. ``signed``: a plus means that it is positive, and not that no sign was written.
    """

    plan: str
    position: str
    segment: str
    mm: float | None = None
    value: float | None = None
    unit: str = ""
    x: float | None = None
    y: float | None = None
    line: int = 0
    last: Last = Last()
    signed: bool = False

    @property
    def key(self) -> tuple[str, str, str]:
        """Plan, segment and position: which figure of the scene it is of."""
        return (self.plan, self.segment, self.position)

    @property
    def in_mm(self) -> bool:
        """Whether it was measured on paper."""
        return self.mm is not None or self.pointed

    @property
    def pointed(self) -> bool:
        """Whether it gives the coordinates of a point."""
        return self.mm is None and self.x is not None and self.y is not None

    @property
    def spot(self) -> complex:
        """Where it says that a point stands, mm from the pole of its plan."""
        assert self.x is not None
        assert self.y is not None
        return complex(self.x, self.y)

    @property
    def at(self) -> tuple[tuple[str, str, str], bool]:
        """Which figure it is of, and whether it was measured on paper: by what its yardstick is known."""
        return self.key, self.in_mm

    def parts(self) -> Iterator[Taken]:
        """Yield a reading for each kind of figure that its row gives: mm, a quantity, a place."""
        bare = self._replace(mm=None, value=None, x=None, y=None)
        if self.mm is not None:
            yield bare._replace(mm=self.mm)
        if self.value is not None:
            yield bare._replace(value=self.value)
        if self.x is not None and self.y is not None:
            yield bare._replace(x=self.x, y=self.y)


class Judged(NamedTuple):
    """A reading with its due: both in mm, or in the unit of ``value`` where it was given as a quantity.

    ``percent``: of the longest vector of the plan, NaN where nothing is drawn of it; ``quantile``: how many of
    the hand's own drawings are farther off (0 … 1, small for a reading that the hand would hardly make);
    ``step``: which step of its plan is blamed, "" for none; ``own``: the error that this step made itself, mm
    (None of a rate). ``follows``: the earlier reading whose deviation it has, though it is right itself.
    ``times``: how many times what the hand is usually off it is, as it was made or else as it is, with its sign
    (of a point without one); NaN where that is not known. ``doubt``: how near to wrong it is, by likelihood: 0
    within twice of what the hand is usually off, 1 at the limit.
    """

    taken: Taken
    found: float
    due: float
    deviation: float
    percent: float
    quantile: float
    verdict: str
    unit: str = "mm"
    step: str = ""
    own: float | None = None
    follows: Taken | None = None
    times: float = math.nan
    doubt: float = 0.0


MISTAKE, SLIP, INSTRUMENT, UNKNOWN, UNSEEN = "mistake", "slip", "instrument", "unknown", "unseen"
"""What a finding may be: a named mistake; a slip of a single reading; an instrument or the paper that is off
(no mistake); wrong readings that no known mistake explains; a mistake that these readings cannot show."""


class Likely(NamedTuple):
    """What readings tell of a drawing: its name, a sentence on this drawing, the lines that it explains.

    ``like``: sentences of other mistakes that no reading given tells apart from it. ``wrong``: how many
    readings were wrong; ``rest``: what of their deviations it leaves, as a share (0 explains all). ``kind``:
    one of `MISTAKE` …; ``family``: of a mistake, which family of mutations it is of ("factor", "operand"),
    for machines. ``plan``, ``segment``, ``position``: where it was made, as readings name it ("" everywhere);
    ``step``: the letter of its step in a ``view`` of the log, "" for none. ``chance``: how sure it is, 0 ... 1.
    """

    name: str
    says: str
    lines: tuple[int, ...]
    wrong: int
    rest: float
    like: tuple[str, ...] = ()
    kind: str = MISTAKE
    family: str = ""
    plan: str = ""
    segment: str = ""
    position: str = ""
    step: str = ""
    chance: float = 0.0
    view: str = ""


class PlanPicture(NamedTuple):
    """A plan as it is due in one position, mm from its pole, and what was found there, or comes of a mistake.

    ``due``, ``found``: a point, or the two ends of a segment; none where it is not known. ``of``: the slots of
    the marks whose ink is meant. ``named``: the point that each label of the drawing names. ``mistaken``: the
    ink that stands otherwise by a mistake, which then draws ``found``, too; None without one.
    """

    drawing: Drawing
    due: tuple[complex, ...] = ()
    found: tuple[complex, ...] = ()
    of: tuple[int, ...] = ()
    named: tuple[complex, ...] = ()
    mistaken: tuple[Ink, ...] | None = None


class Lesson(NamedTuple):
    """What a step of the construction is, for who did it wrongly.

    ``step``: as `Judged` names it, in its ``plan``, there drawn in a ``view`` of the log; ``letter``: of what
    it leaves, as people write it. ``says`` what is done, ``why``, and how it is calculated in one ``position``:
    with the ``own`` numbers of the drawing where they were read, else with the exact ones. ``shown``: the
    reading that is off the most. ``names``: which of the report's mistakes (by number, from 0) were made in it.
    ``segment``: the figure of a table that it leaves, where readings of that blame no step themselves.
    ``drawn``: of what is measured, the sentences of the steps that drew it, each with its number. ``shows``:
    the later reading in which a mistake shows that was made in the step. ``title``: what the view is called.
    """

    plan: str
    step: str
    letter: str
    says: str
    why: str = ""
    calculation: str = ""
    position: str = ""
    own: bool = False
    shown: Judged | None = None
    picture: PlanPicture | None = None
    names: tuple[int, ...] = ()
    segment: str = ""
    view: str = ""
    drawn: tuple[str, ...] = ()
    shows: Judged | None = None
    title: str = ""


class Whole(NamedTuple):
    """A drawing that is off as a whole: so ``rare`` is it among the hand's (a share).

    ``doubtful``: how many ``of`` its readings are so, none of which is wrong; how many are ``due`` to be.
    """

    rare: float
    doubtful: int
    due: float
    of: int


class PlanSight(NamedTuple):
    """How many plans of a kind a photograph was to show, and at which positions it does not.

    ``partly``: those of which some points were seen.
    """

    plan: str
    asked: int
    unseen: tuple[str, ...]
    partly: tuple[str, ...] = ()


class Sight(NamedTuple):
    """What a photograph showed: how many points of how many, and of which plans all is seen."""

    points: int
    of: int
    plans: tuple[PlanSight, ...]

    @property
    def whole(self) -> bool:
        """Whether every plan that was asked for was seen."""
        return not any(one.unseen or one.partly for one in self.plans)


class OwnScale(NamedTuple):
    """A scale factor in which a plan was drawn and is judged, or what speaks for one and against it.

    ``mu``, ``due``: SI a mm, his and the scene's; ``by``: what says so: "stated", "rows", "rates", "round",
    "lengths", "" where it is as due; ``agree`` figures ``among`` so many. ``first``: the segment that is laid
    off first; ``places``: μ of positions that have another. ``against``: how many times as long as due the plan
    is, and how many times his rates say that, where they differ.
    """

    plan: str
    view: str
    symbol: str
    mu: float
    due: float
    unit: str
    by: str
    agree: int = 0
    among: int = 0
    first: str = ""
    places: tuple[tuple[str, float], ...] = ()
    against: tuple[float, float] = (1.0, 1.0)


class Report(NamedTuple):
    """A check: the scene, the hand, every reading judged, the mistakes that would explain the wrong ones.

    ``lessons``: on the steps that readings or mistakes blame, in the order of the log. ``whole``: how far off
    the drawing is as a whole, if it is. ``sight``: what was seen of a photograph, if one was read. ``head``:
    sentences on how it was judged, which come first; ``scales``: the scale factors that are not the scene's.
    """

    scene: str
    title: str
    language: str
    hand: str
    readings: tuple[Judged, ...]
    mistakes: tuple[Likely, ...]
    notes: tuple[str, ...] = ()
    lessons: tuple[Lesson, ...] = ()
    whole: Whole | None = None
    sight: Sight | None = None
    head: tuple[str, ...] = ()
    scales: tuple[OwnScale, ...] = ()

    @property
    def wrong(self) -> int:
        """How many readings are wrong."""
        return sum(one.verdict == WRONG for one in self.readings)
