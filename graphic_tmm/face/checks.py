"""Readings of a hand-made drawing, compared with the exact one."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, NamedTuple, get_args

from graphic_tmm.checking.readings.read import read_readings, readings_of
from graphic_tmm.checking.records import Report, Taken
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.text import text_report
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.face.refusals import absent, refuse_out_of_range
from graphic_tmm.language.said import said

Readings = (
    str | os.PathLike[str] | bytes | Mapping[str, Sequence[Any]] | Iterable[Mapping[str, Any]]
)
"""What readings may be taken from."""
Judge = Literal["cad", "careful", "student"]
"""Hands by whose drawings readings may be judged: those that slip."""
Way = Literal["paper", "screen", "photo", "own sheet"]
"""How points are read."""
WIDTH = 110
"""Characters of a line of a printed report."""
NAME = "readings"
"""What readings are called that no file holds."""


class Verdict(NamedTuple):
    """What is judged of one reading.

    ``verdict``: fine, doubtful or wrong. ``found`` and ``due`` in its ``unit``, ``deviation`` between them
    (of a point its distance, mm); ``percent``: of the longest vector of the plan. ``step``: that is blamed.
    """

    plan: str
    position: str
    segment: str
    verdict: str
    found: float
    due: float
    deviation: float
    unit: str
    percent: float
    step: str


class Mistake(NamedTuple):
    """What would explain the wrong readings: its ``name``, a sentence, how sure it is (0 ... 1), where."""

    name: str
    says: str
    chance: float
    plan: str
    position: str
    segment: str


class Check:
    """What there is to say of a drawing made by hand; the same as ``graphic-tmm check`` prints.

    Parameters
    ----------
    report : checking.records.Report
        All that was found.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> found = tmm.draw("crank-rocker").check(
    ...     [{"plan": "velocities", "position": 1, "segment": "pa", "mm": 83.0}]
    ... )
    >>> found.ok, found.verdicts[0].verdict, found.verdicts[0].due
    (False, 'wrong', 50.26...)
    """

    def __init__(self, report: Report) -> None:
        self._report = report

    @property
    def ok(self) -> bool:
        """Whether nothing is wrong."""
        return self._report.wrong == 0

    @property
    def wrong(self) -> int:
        """How many readings are wrong."""
        return self._report.wrong

    @property
    def verdicts(self) -> tuple[Verdict, ...]:
        """What is judged of each reading, in their order."""
        return tuple(
            Verdict(
                one.taken.plan,
                one.taken.position,
                one.taken.segment,
                one.verdict,
                one.found,
                one.due,
                one.deviation,
                one.unit,
                one.percent,
                one.step,
            )
            for one in self._report.readings
        )

    @property
    def mistakes(self) -> tuple[Mistake, ...]:
        """What would explain what is wrong, the most likely first."""
        return tuple(
            Mistake(one.name, one.says, one.chance, one.plan, one.position, one.segment)
            for one in self._report.mistakes
        )

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as the command writes it with ``-f json``; figures of 12 digits, None for none."""
        found: dict[str, Any] = json.loads(json_report(self._report))
        return found

    def to_records(self) -> list[dict[str, Any]]:
        """Return a dictionary for each reading, with the names of the command's JSON."""
        found: list[dict[str, Any]] = self.to_dict()["readings"]
        return found

    def to_pandas(self) -> Any:
        """Return the readings as a data frame, with the names of the command's JSON.

        Returns
        -------
        pandas.DataFrame
            A row for each reading.

        Raises
        ------
        MissingError
            If pandas is not installed.
        """
        from graphic_tmm.errors import needed

        return needed("pandas", "pandas").DataFrame(self.to_records())

    def __repr__(self) -> str:
        return printed(text_report(self._report))

    def _repr_html_(self) -> str:
        """Return the report for a notebook: the page of the command, in a frame of its own."""
        from graphic_tmm.face.html import rendered

        return rendered("frame.html", page=html_report(self._report))


def taken_of(readings: Any) -> tuple[tuple[Taken, ...], str]:
    """Return readings from wherever they stand, and what that is called in messages.

    Raises
    ------
    SceneError
        If they cannot be read: every fault, each with its column and its line.
    """
    if isinstance(readings, bytes):
        return readings_of(Path(NAME), readings), NAME
    if isinstance(readings, str) and "\n" in readings:
        return readings_of(Path(NAME), readings.encode("utf-8", "surrogatepass")), NAME
    if isinstance(readings, (str, os.PathLike)):
        return read_readings(Path(readings)), os.fspath(readings)
    return readings_of(Path(NAME), _csv(_records(readings)).encode("utf-8")), NAME


def _records(readings: Any) -> list[Mapping[str, Any]]:
    """Return readings as a dictionary each."""
    if hasattr(readings, "to_dict") and hasattr(readings, "columns"):  # a data frame of pandas
        readings = readings.to_dict("records")
    if isinstance(readings, Mapping):
        if not all(isinstance(one, (list, tuple)) for one in readings.values()):
            readings = [readings]
        else:
            rows = zip(*readings.values(), strict=False)
            readings = [dict(zip(readings, row, strict=True)) for row in rows]
    found = list(readings) if isinstance(readings, Iterable) else [readings]
    if not all(isinstance(one, Mapping) for one in found):
        says = said(
            "readings are a file, its text, or records with plan, position, segment and mm, not {kind}",
            kind=type(readings).__name__,
        )
        raise SceneError(NAME, (Fault("", 0, says),))
    return found


def _csv(records: Sequence[Mapping[str, Any]]) -> str:
    """Return records as the text of a file, a line each, so that they are read as files are."""
    heads = list(dict.fromkeys(str(key) for one in records for key in one))
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(heads)
    for one in records:
        cells = {str(key): value for key, value in one.items()}
        writer.writerow([_cell(cells.get(head)) for head in heads])
    return out.getvalue()


def _cell(value: Any) -> str:
    """Return a value as a cell: figures to the digits that they have, nothing for None and NaN."""
    if value is None or value != value:
        return ""
    if isinstance(value, float):
        return f"{value:.12g}"
    return " ".join(str(value).split())


def printed(parts: Sequence[Any]) -> str:
    """Return what rich makes of a report, as plain text."""
    from rich.console import Console

    console = Console(width=WIDTH, file=io.StringIO(), color_system=None)
    with console.capture() as written:
        for part in parts:
            console.print(part)
    return written.get()


def judges(hand: str, points: str, trials: int, doubtful: float, wrong: float) -> None:
    """Refuse what nothing can be judged by.

    Raises
    ------
    AbsentError
        If there is no such hand that slips, or no such way to read points.
    SheetError
        If a number is out of its range.
    """
    for name, known in ((hand, get_args(Judge)), (points, get_args(Way))):
        if name not in known:
            raise absent(name, known)
    limits = {"trials": (trials, 20, 100_000), "doubtful": (doubtful, 0.5, 1.0)}
    limits["wrong"] = (wrong, 1.0, 100.0)
    for name, (value, least, most) in limits.items():
        refuse_out_of_range(name, value, least, most)
