"""Signs of readings: where one figure of a column bears a minus, the signs of all of it are meant."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.checking.records import Taken

Column = tuple[str, str, bool]


def with_signs(rows: Sequence[Taken]) -> tuple[Taken, ...]:
    """Return readings, marked where their sign is meant: in columns in which some figure bears a minus.

    A column is a segment of a plan measured in mm, or quantities called by one letter (ω of all links). Where
    none bears a minus magnitudes were written, and a plus tells nothing.
    """
    meant = {_column(taken) for taken in rows if _figure(taken) < 0.0}
    return tuple(
        taken._replace(signed=True) if not taken.pointed and _column(taken) in meant else taken
        for taken in rows
    )


def _figure(taken: Taken) -> float:
    return (taken.mm if taken.mm is not None else taken.value) or 0.0


def _column(taken: Taken) -> Column:
    in_mm = taken.mm is not None
    return taken.plan, taken.segment if in_mm else taken.segment.rstrip("0123456789"), in_mm
