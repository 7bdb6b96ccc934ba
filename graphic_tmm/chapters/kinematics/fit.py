"""Whether a passive link has the length that the links which hold it keep over the whole turn."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.bodies import Passive
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Sweep

FITS = 1e-4
"""A length that is off by less than this share of it was rounded: it is written with four digits."""


class _Size(NamedTuple):
    """A size that a passive link has (m), its name, and the same over the turn as its holders keep it."""

    name: str
    own: float
    kept: Reals
    least: float


def check_fit(tried: Survey) -> None:
    """Refuse a passive link that does not fit what holds it.

    Raises
    ------
    StructureError
        If its letters stand as far apart as it is long nowhere, or not over the whole turn; the message says
        by how many mm, and where.
    """
    held = tried.positions.passive
    if not held:
        return
    bodies = tried.positions.bodies
    wanted = [mark for one in held for mark in (*bodies[one.link].marks.values(), one.axis)]
    angles, reading = tried.whole(wanted)
    for one in held:
        for size in _sizes(tried, one, reading):
            _refuse(one, size, angles[0], tried.sweep)


def _sizes(tried: Survey, passive: Passive, reading: Reading) -> list[_Size]:
    body = tried.positions.bodies[passive.link]
    own, spots = body.own, {letter: reading[mark][0] for letter, mark in body.marks.items()}
    letters = [letter for letter, _ in passive.pins]
    found = []
    for k, letter in enumerate(letters[1:], start=1):
        for other in letters[:k]:
            length = abs(own[letter] - own[other])
            kept = np.abs(spots[letter] - spots[other])
            name = said("length {letters}", letters=f"{other}{letter}")
            found.append(_Size(name, length, kept, FITS * length))
    if passive.slide is not None:
        path, spot, offset = reading[passive.axis], spots[letters[0]], passive.slide.offset
        kept = offset + np.imag((spot - path.at[0]) * np.conj(path.along[0]))
        least = FITS * float(np.nanmax(np.abs(spot)))
        found.append(_Size(said("offset from its guide"), offset, kept, least))
    return found


def _refuse(passive: Passive, size: _Size, row: Reals, sweep: Sweep) -> None:
    kept = np.broadcast_to(size.kept, row.shape)
    there = np.flatnonzero(np.isfinite(kept))
    if not there.size:
        return
    off = kept[there] - size.own
    if np.abs(off).max() <= size.least:
        return
    low, high, far = (int(there[k]) for k in (off.argmin(), off.argmax(), np.abs(off).argmax()))
    key = f"link {passive.link}, " + ("points" if passive.slide is None else "slides, offset")
    if kept[high] - kept[low] <= size.least:
        raise StructureError(
            said(
                "link {link} is passive and does not fit: {name} is {own} mm, but what holds it keeps "
                "{kept} mm in all positions, so it is {off} mm off; write {kept} mm",
                link=passive.link,
                name=size.name,
                own=_mm(size.own),
                kept=_mm(kept[far]),
                off=_mm(abs(kept[far] - size.own)),
            ),
            key,
        )
    raise StructureError(
        said(
            "link {link} is passive and does not fit: {name} is {own} mm, but what holds it goes from "
            "{low} mm (at {at}) to {high} mm (at {there}), so it is up to {off} mm off and "
            "would lock the mechanism; change its points or those of the links that hold it, or take it out",
            link=passive.link,
            name=size.name,
            own=_mm(size.own),
            low=_mm(kept[low]),
            at=coordinate_text(row[low], sweep),
            high=_mm(kept[high]),
            there=coordinate_text(row[high], sweep),
            off=_mm(abs(kept[far] - size.own)),
        ),
        key,
    )


def coordinate_text(value: float, sweep: Sweep) -> str:
    """Return a coordinate of the drive: φ = 35°, s = 120 mm."""
    told = f"{value:.4g}°" if sweep.turns else f"{_mm(value)} mm"
    return f"{sweep.letter} = {told}"


def _mm(size: float) -> str:
    """Return a length (m) in mm, to five digits and no finer than 1 nm."""
    return f"{round(1000.0 * size, 6) + 0.0:.5g}".replace("-", "−")
