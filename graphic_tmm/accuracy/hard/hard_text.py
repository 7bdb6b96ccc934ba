"""What is told of a walk along the turn: a sentence, a strip along φ for each plan, a table of hard places."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from graphic_tmm.accuracy.hard.hard_places import HardPlace, degrees_apart
from graphic_tmm.accuracy.hard.walk import MOST, OFFS, PLANS, Result, Walk
from graphic_tmm.board.findings import Finding, step_number
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.readers.findings import reason
from graphic_tmm.scene.packaged import scene_name

CELL = 5.0
"""Degrees that a sign of a strip stands for."""
MANY, ZERO, GONE = "·", "∘", "×"
LABELS = dict(zip(PLANS, ("r", "v, ω", "a, ε", "R, P"), strict=True))
"""What the strips are called."""
FEW = 10
"""From so many digits on none is counted."""
SHOWN = 6
"""So many hard places are printed, those with the fewest digits."""
TOUCHES = 1e6
"""What magnifies rounding so many times is told as what it comes to: the lines are parallel."""
SPACE = "\N{NO-BREAK SPACE}"
_RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def hard_text(walk: Walk) -> str:
    """Return what is printed of a walk, no line longer than 80 characters."""
    from textwrap import fill

    language = walk.sheet.scene.language
    lines = [*(fill(one, 79) for one in sentences(walk)), "", *_strips(walk)]
    shown = _hardest(walk)
    if shown:
        lines += ["", *_heads(language)]
    for place in shown:
        lines += [*fill(_title(walk, place), 79).splitlines(), *_digits(walk, place, language)]
    if len(walk.places) > len(shown):
        _ = speaking(language)
        n = len(walk.places) - len(shown)
        lines += [
            "",
            _("And {n} hard place more: -f json.", "And {n} hard places more: -f json.", n=n),
        ]
    return "\n".join(lines) + "\n"


def hard_json(walk: Walk) -> str:
    """Return a walk as a JSON text: all digits at all angles, the hard places, why what is left out."""
    project, language = walk.sheet.project, walk.sheet.scene.language
    found = {
        "scene": scene_name(walk.sheet.scene.source),
        "angles_deg": walk.angles.tolist(),
        "results": [
            {
                "plan": one.plan,
                "result": one.letter,
                "digits": [None if np.isnan(d) else round(float(d), 1) for d in digits],
                "cannot_be_drawn": np.flatnonzero(missing).tolist(),
            }
            for one, digits, missing in zip(walk.results, walk.digits, walk.missing, strict=True)
        ],
        "places": [_place(walk, one) for one in walk.places],
        "undrawn": [
            {
                "angles_deg": [float(walk.angles[k]) for k in one.positions],
                "reason": reason(one._replace(gap=None), project, language),
            }
            for one in walk.findings
        ],
        "sentences": [*sentences(walk)],
    }
    return json.dumps(found, ensure_ascii=False, indent=1) + "\n"


def _place(walk: Walk, place: HardPlace) -> dict[str, Any]:
    rows = [_near(walk, place, off) for off in (*OFFS, 0.0)]
    return {
        "angle_deg": place.angle,
        "kind": place.kind,
        "says": _title(walk, place),
        "off_deg": [*OFFS, 0.0],
        "best": [_most(row) for row in rows],
        "worst": [_least(row) for row in rows],
    }


def sentences(walk: Walk) -> Iterator[str]:
    """Yield the result whose digits are fewest, where and why; the same away from zero; what is left out."""
    _ = speaking(walk.sheet.scene.language)
    digits = np.where(np.isnan(walk.digits), np.inf, walk.digits)
    if not np.isfinite(digits).any():
        yield _("Nothing can be drawn at any angle.")
        return
    k, i = np.unravel_index(np.argmin(digits), digits.shape)
    most = int(MOST)
    if walk.small[k, i]:
        yield _(
            "Fewest digits are left of {it} at φ = {at}: {n} of {most}, for it is all but zero there itself.",
            it=walk.results[k].letter,
            at=_angle(walk, int(i)),
            n=int(digits[k, i]),
            most=most,
        )
        digits = np.where(walk.small, np.inf, digits)
        k, i = np.unravel_index(np.argmin(digits), digits.shape)
        says = _(
            "Of figures that are not so small at least {n} are left: of {it} at φ = {at}.",
            it=walk.results[k].letter,
            at=_angle(walk, int(i)),
            n=int(digits[k, i]),
        )
    else:
        says = _(
            "Fewest digits are left of {it} at φ = {at}: {n} of {most}.",
            it=walk.results[k].letter,
            at=_angle(walk, int(i)),
            n=int(digits[k, i]),
            most=most,
        )
    near = walk.nearest(float(walk.angles[i]))
    close = near is not None and degrees_apart(near.angle, float(walk.angles[i])) < CELL
    if near is not None and close and near.kind != "still":
        says = f"{says} {_('Why: {why}.', why=_why(walk, near))}"
    yield says
    if walk.even.any() and np.isfinite(even := digits[:, walk.even]).any():
        yield _("Farther than 1° from every hard place at least {n}.", n=int(even.min()))
    yield from _left_out(walk, _)


def _left_out(walk: Walk, _: Speech) -> Iterator[str]:
    """Yield what cannot be drawn, and of what no digit is sure."""
    project, language = walk.sheet.project, walk.sheet.scene.language
    if not (walk.missing.any() or walk.lost.any()):
        yield _("Nothing is left out.")
    for one in walk.findings:
        yield _(
            "Cannot be drawn (×) at φ = {at}: {why}.",
            at=", ".join(_spans(walk, one.positions)),
            why=reason(one._replace(gap=None), project, language),
        )
    gone = walk.lost.any(axis=0)
    if gone.any():
        letters = [
            one.letter for one, row in zip(walk.results, walk.lost, strict=True) if row.any()
        ]
        yield _(
            "Left out (×), for rounding leaves no digit that is sure: {letters}; φ = {at}.",
            letters=", ".join(letters),
            at=", ".join(_about(walk, np.flatnonzero(gone))),
        )


def _spans(walk: Walk, positions: Sequence[int]) -> Iterator[str]:
    """Yield the parts of the turn that consist of neighbouring angles."""
    parts = np.split(np.array(positions), np.flatnonzero(np.diff(positions) > 1) + 1)
    for part in parts:
        ends = [_angle(walk, int(k)) for k in (part[0], part[-1])]
        yield ends[0] if ends[0] == ends[1] else " … ".join(ends)


def _about(walk: Walk, positions: Iterable[int]) -> Iterator[str]:
    """Yield how far from hard places angles are, the farthest of each; those that are near to none."""
    language = walk.sheet.scene.language
    farthest: dict[float, float] = {}
    alone: list[int] = []
    for k in positions:
        angle = float(walk.angles[k])
        place = walk.nearest(angle)
        if place is None or degrees_apart(place.angle, angle) > 1.5 * OFFS[0]:
            alone.append(int(k))
        else:
            off = degrees_apart(place.angle, angle)
            farthest[place.angle] = max(off, farthest.get(place.angle, 0.0))
    for angle, off in farthest.items():
        reach = f"{SPACE}±{SPACE}{_off(off, language)}°" if off > 0.0 else ""
        yield f"{number(angle, language, 7)}°{reach}"
    yield from _spans(walk, alone) if alone else ()


def _angle(walk: Walk, k: int) -> str:
    """Return an angle: by how much it is off a hard place where it is very near to it."""
    language, angle = walk.sheet.scene.language, float(walk.angles[k])
    place = walk.nearest(angle)
    off = 0.0 if place is None else (angle - place.angle + 180.0) % 360.0 - 180.0
    if place is None or not 0.0 < abs(off) < 0.5:
        return f"{number(angle, language, 7)}°"
    sign = "+" if off > 0.0 else "−"
    return f"{number(place.angle, language, 7)}°{SPACE}{sign}{SPACE}{_off(abs(off), language)}°"


def _strips(walk: Walk) -> Iterator[str]:
    """Yield a strip for each plan: a sign for five degrees, each turn of the row by itself."""
    _ = speaking(walk.sheet.scene.language)
    yield _(
        "Digits left of the worst result, a sign for 5°: {many} ten or more, {gone} left out,",
        many=MANY,
        gone=GONE,
    )
    yield _(
        "{zero} fewer than ten, but only of a figure that passes through zero there:", zero=ZERO
    )
    in_turn = int(360.0 / CELL)
    for turn in range(round(walk.whole / 360.0)):
        yield "φ".ljust(6) + "".join(f"{360 * turn + 45 * k}°".ljust(9) for k in range(8)).rstrip()
        for plan, label in LABELS.items():
            rows = [k for k, one in enumerate(walk.results) if one.plan == plan]
            if rows:
                cells = range(turn * in_turn, (turn + 1) * in_turn)
                yield label.ljust(6) + "".join(_sign(walk, rows, cell) for cell in cells)
    yield _("r places of points; v, ω speeds; a, ε accelerations; R, P forces, what balances.")


def _sign(walk: Walk, rows: Sequence[int], cell: int) -> str:
    inside = np.floor(walk.angles / CELL) == cell
    digits, small = walk.digits[rows][:, inside], walk.small[rows][:, inside]
    least = _least(digits)
    if least is None:
        return GONE
    if least >= FEW:
        return MANY
    least = _least(np.where(small, FEW, digits))
    return str(least) if least is not None and least < FEW else ZERO


def _least(digits: Any) -> int | None:
    """Return the fewest digits; None where something is left out."""
    return None if np.isnan(digits).any() else int(np.min(digits))


def _most(digits: Any) -> int | None:
    there = digits[np.isfinite(digits)]
    return int(there.max()) if there.size else None


def _near(walk: Walk, place: HardPlace, off: float) -> Any:
    """Return the digits of all results so far from a hard place, to both sides; inside of an end."""
    sides = [walk.at(place.angle + off), walk.at(place.angle - off)]
    if place.kind == "end":
        sides = [min(sides, key=lambda k: int(walk.missing[:, k].sum()))]
    return walk.digits[:, sides]


def _hardest(walk: Walk) -> list[HardPlace]:
    """Return the hard places that are printed: what is not points that stand still comes first; by angle."""

    def digits(place: HardPlace) -> tuple[bool, float]:
        found = [_near(walk, place, off) for off in OFFS]
        return place.kind == "still", float(np.mean(np.nan_to_num(found)))

    return sorted(sorted(walk.places, key=digits)[:SHOWN])


def _heads(language: str) -> Iterator[str]:
    _ = speaking(language)
    yield _("Hard places: digits of the best and the worst result, degrees beside them:")
    heads = [_off(off, language) for off in (*OFFS, 0.0)]
    yield "".ljust(8) + "".join(head.rjust(6) for head in heads)


def _off(off: float, language: str) -> str:
    if off >= 0.05 or off == 0.0:
        return number(off, language, 1)
    return f"10⁻{str(round(-np.log10(off))).translate(_RAISED)}"


def _digits(walk: Walk, place: HardPlace, language: str) -> Iterator[str]:
    _ = speaking(language)
    rows = [_near(walk, place, off) for off in (*OFFS, 0.0)]
    for says, of in ((_("best"), _most), (_("worst"), _least)):
        told = [of(row) for row in rows]
        yield says.ljust(8) + "".join((GONE if n is None else str(n)).rjust(6) for n in told)


def _title(walk: Walk, place: HardPlace) -> str:
    """Return what a hard place is, and which result has the fewest digits there."""
    language = walk.sheet.scene.language
    _ = speaking(language)
    rows = [_near(walk, place, off) for off in OFFS]
    sums = np.nansum([np.min(row, axis=1) for row in rows], axis=0)
    return _(
        "φ = {at}°: {why}; worst: {it}",
        at=number(place.angle, language, 7),
        why=_why(walk, place),
        it=walk.results[int(np.argmin(sums))].letter,
    )


def _why(walk: Walk, place: HardPlace) -> str:
    language, log = walk.sheet.scene.language, walk.sheet.construction
    _ = speaking(language)
    if place.kind == "still":
        owners = [_owner(one) for one in walk.results if one.row.mark in place.still]
        return _("dead centre, {points} at rest", points=", ".join(dict.fromkeys(owners)))
    if place.step is None:
        return _("the range of the crank ends")
    touches = place.kind == "sharp" and place.times > TOUCHES and bool(place.step.op.gaps)
    kind, place_in_view = "touching" if touches else "undrawn", step_number(log, place.step)
    why = reason(Finding(kind, place.step, place_in_view, (), 0.0), walk.sheet.project, language)
    if place.kind == "end":
        return _("the range of the crank ends: {why}", why=why)
    if place.times > TOUCHES:
        return why
    return _(
        "rounding is magnified {times} times, not far from this: {why}",
        times=number(place.times, language, 2),
        why=why,
    )


def _owner(one: Result) -> str:
    return str(one.row.key[0]) if isinstance(one.row.key, tuple) else str(one.row.key)
