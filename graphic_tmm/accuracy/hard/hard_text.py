"""What is told of the walk of a drive: a sentence, a strip for each plan, a table of hard places."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from math import ceil
from typing import Any

import numpy as np

from graphic_tmm.accuracy.hard.hard_places import HardPlace
from graphic_tmm.accuracy.hard.span import SPACE, Coordinates
from graphic_tmm.accuracy.hard.walk import MOST, PLANS, Result, Walk
from graphic_tmm.board.findings import Finding, step_number
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.readers.findings import reason
from graphic_tmm.scene.packaged import scene_name

MANY, ZERO, GONE = "·", "∘", "×"
LABELS = dict(zip(PLANS, ("r", "v, ω", "a, ε", "R, P"), strict=True))
"""What the strips are called."""
NEAR = 0.05
"""Nearer to a hard place than this share of the farthest off (10°) a place is called by how far it is off."""
HEADED, WIDELY = 9, 12
"""Over every so many signs of a strip its coordinate is printed, of a turn and of lengths."""
LAST = 4
"""Over the last signs none is printed: it would go over the margin."""
LAST_BITS = 1e-9
"""The share of a sign by which a coordinate may be off its beginning for rounding alone."""
FEW = 10
"""From so many digits on none is counted."""
SHOWN = 6
"""So many hard places are printed, those with the fewest digits."""
TOUCHES = 1e6
"""What magnifies rounding so many times is told as what it comes to: the lines are parallel."""
_RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def hard_text(walk: Walk) -> str:
    """Return what is printed of a walk, no line longer than 80 characters."""
    from textwrap import fill

    language = walk.sheet.scene.language
    lines = [*(fill(one, 79) for one in sentences(walk)), "", *_strips(walk)]
    shown = _hardest(walk)
    if shown:
        lines += ["", *_heads(walk)]
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
    """Return a walk as a JSON text: all digits everywhere, the hard places, why what is left out."""
    project, language = walk.sheet.project, walk.sheet.scene.language
    row = f"{'angles' if walk.span.turns else 'lengths'}_{_unit(walk)}"
    found = {
        "scene": scene_name(walk.sheet.scene.source),
        row: _in_json(walk, walk.row),
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
                row: _in_json(walk, walk.row[[*one.positions]]),
                "reason": reason(one._replace(gap=None), project, language),
            }
            for one in walk.findings
        ],
        "sentences": [*sentences(walk)],
    }
    return json.dumps(found, ensure_ascii=False, indent=1) + "\n"


def _place(walk: Walk, place: HardPlace) -> dict[str, Any]:
    offs = (*walk.span.offs, 0.0)
    rows = [_near(walk, place, off) for off in offs]
    return {
        f"{'angle' if walk.span.turns else 'length'}_{_unit(walk)}": place.at * walk.span.in_si,
        "kind": place.kind,
        "says": _title(walk, place),
        f"off_{_unit(walk)}": _in_json(walk, np.array(offs)),
        "best": [_most(row) for row in rows],
        "worst": [_least(row) for row in rows],
    }


def _unit(walk: Walk) -> str:
    return "deg" if walk.span.turns else "m"


def _in_json(walk: Walk, row: Coordinates) -> list[float]:
    """Return coordinates as files have them: degrees or m."""
    return [float(at) for at in row * walk.span.in_si]


def sentences(walk: Walk) -> Iterator[str]:
    """Yield the result whose digits are fewest, where and why; the same away from zero; what is left out."""
    _ = speaking(walk.sheet.scene.language)
    digits = np.where(np.isnan(walk.digits), np.inf, walk.digits)
    if not np.isfinite(digits).any():
        yield _("Nothing can be drawn in any position.")
        return
    k, i = np.unravel_index(np.argmin(digits), digits.shape)
    most = int(MOST)
    if walk.small[k, i]:
        yield _(
            "Fewest digits are left of {it} at {at}: {n} of {most}, for it is all but zero there itself.",
            it=walk.results[k].letter,
            at=walk.span.at(_place_name(walk, int(i))),
            n=int(digits[k, i]),
            most=most,
        )
        digits = np.where(walk.small, np.inf, digits)
        k, i = np.unravel_index(np.argmin(digits), digits.shape)
        says = _(
            "Of figures that are not so small at least {n} are left: of {it} at {at}.",
            it=walk.results[k].letter,
            at=walk.span.at(_place_name(walk, int(i))),
            n=int(digits[k, i]),
        )
    else:
        says = _(
            "Fewest digits are left of {it} at {at}: {n} of {most}.",
            it=walk.results[k].letter,
            at=walk.span.at(_place_name(walk, int(i))),
            n=int(digits[k, i]),
            most=most,
        )
    near = walk.nearest(float(walk.row[i]))
    close = near is not None and walk.span.apart(near.at, float(walk.row[i])) < walk.span.cell
    if near is not None and close and near.kind != "still":
        says = f"{says} {_('Why: {why}.', why=_why(walk, near))}"
    yield says
    if walk.even.any() and np.isfinite(even := digits[:, walk.even]).any():
        far = walk.span.value(walk.span.offs[1], walk.sheet.scene.language)
        yield _(
            "Farther than {far} from every hard place at least {n}.", far=far, n=int(even.min())
        )
    yield from _left_out(walk, _)


def _left_out(walk: Walk, _: Speech) -> Iterator[str]:
    """Yield what cannot be drawn, and of what no digit is sure."""
    project, language = walk.sheet.project, walk.sheet.scene.language
    if not (walk.missing.any() or walk.lost.any()):
        yield _("Nothing is left out.")
    for one in walk.findings:
        yield _(
            "Cannot be drawn (×) at {at}: {why}.",
            at=walk.span.at(", ".join(_spans(walk, one.positions))),
            why=reason(one._replace(gap=None), project, language),
        )
    gone = walk.lost.any(axis=0)
    if gone.any():
        letters = [
            one.letter for one, row in zip(walk.results, walk.lost, strict=True) if row.any()
        ]
        yield _(
            "Left out (×), for rounding leaves no digit that is sure: {letters}; {at}.",
            letters=", ".join(letters),
            at=walk.span.at(", ".join(_about(walk, np.flatnonzero(gone)))),
        )


def _spans(walk: Walk, positions: Sequence[int]) -> Iterator[str]:
    """Yield the parts that consist of neighbouring places."""
    parts = np.split(np.array(positions), np.flatnonzero(np.diff(positions) > 1) + 1)
    for part in parts:
        ends = [_place_name(walk, int(k)) for k in (part[0], part[-1])]
        yield ends[0] if ends[0] == ends[1] else " … ".join(ends)


def _about(walk: Walk, positions: Iterable[int]) -> Iterator[str]:
    """Yield how far from hard places some places are, the farthest of each; those that are near to none."""
    language, span = walk.sheet.scene.language, walk.span
    farthest: dict[float, float] = {}
    alone: list[int] = []
    for k in positions:
        at = float(walk.row[k])
        place = walk.nearest(at)
        if place is None or span.apart(place.at, at) > 1.5 * span.offs[0]:
            alone.append(int(k))
        else:
            farthest[place.at] = max(span.apart(place.at, at), farthest.get(place.at, 0.0))
    for at, off in farthest.items():
        yield f"{span.value(at, language)}{_aside_of(walk, '±', off) if off > 0.0 else ''}"
    yield from _spans(walk, alone) if alone else ()


def _place_name(walk: Walk, k: int) -> str:
    """Return a place: by how much it is off a hard one where it is very near to it."""
    language, span, at = walk.sheet.scene.language, walk.span, float(walk.row[k])
    place = walk.nearest(at)
    off = 0.0 if place is None else float(span.off(np.asarray(at), place.at))
    if place is None or not 0.0 < abs(off) < NEAR * span.offs[0]:
        return span.value(at, language)
    return f"{span.value(place.at, language)}{_aside_of(walk, '+' if off > 0.0 else '−', abs(off))}"


def _aside_of(walk: Walk, sign: str, off: float) -> str:
    """Return how far something is from a hard place, as it stands behind that: + 10⁻³°."""
    language = walk.sheet.scene.language
    return f"{SPACE}{sign}{SPACE}{_off(off, language)}{walk.span.behind(language)}"


def _strips(walk: Walk) -> Iterator[str]:
    """Yield a strip for each plan: signs for equal parts, each turn of the row by itself."""
    language, span = walk.sheet.scene.language, walk.span
    _ = speaking(language)
    yield _(
        "Digits left of the worst result, a sign for {cell}: {many} ten or more, {gone} left out,",
        cell=span.value(span.cell, language),
        many=MANY,
        gone=GONE,
    )
    yield _(
        "{zero} fewer than ten, but only of a figure that passes through zero there:", zero=ZERO
    )
    signs, wide = ceil(span.once / span.cell - LAST_BITS), HEADED if span.turns else WIDELY
    for turn in range(round((span.high - span.low) / span.once)):
        begun = span.low + turn * span.once
        heads = (span.value(begun + k * span.cell, language) for k in range(0, signs - LAST, wide))
        yield span.letter.ljust(6) + "".join(head.ljust(wide) for head in heads).rstrip()
        for plan, label in LABELS.items():
            rows = [k for k, one in enumerate(walk.results) if one.plan == plan]
            if rows:
                cells = range(turn * signs, (turn + 1) * signs)
                yield label.ljust(6) + "".join(_sign(walk, rows, cell) for cell in cells)
    yield _("r places of points; v, ω speeds; a, ε accelerations; R, P forces, what balances.")


def _sign(walk: Walk, rows: Sequence[int], cell: int) -> str:
    inside = np.floor((walk.row - walk.span.low) / walk.span.cell + LAST_BITS) == cell
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
    sides = [walk.index(place.at + off), walk.index(place.at - off)]
    if place.kind == "end":
        sides = [min(sides, key=lambda k: int(walk.missing[:, k].sum()))]
    return walk.digits[:, sides]


def _hardest(walk: Walk) -> list[HardPlace]:
    """Return the hard places that are printed: what is not points that stand still comes first; by angle."""

    def digits(place: HardPlace) -> tuple[bool, float]:
        found = [_near(walk, place, off) for off in walk.span.offs]
        return place.kind == "still", float(np.mean(np.nan_to_num(found)))

    return sorted(sorted(walk.places, key=digits)[:SHOWN])


def _heads(walk: Walk) -> Iterator[str]:
    language = walk.sheet.scene.language
    _ = speaking(language)
    off = walk.span.behind(language).strip()
    yield _("Hard places: digits of the best and the worst result so far off, {unit}:", unit=off)
    heads = [_off(off, language) for off in (*walk.span.offs, 0.0)]
    yield "".ljust(8) + "".join(head.rjust(6) for head in heads)


def _off(off: float, language: str) -> str:
    if off >= 0.05 or off == 0.0:
        return number(off, language, 1)
    return f"10⁻{str(round(-np.log10(off))).translate(_RAISED)}"


def _digits(walk: Walk, place: HardPlace, language: str) -> Iterator[str]:
    _ = speaking(language)
    rows = [_near(walk, place, off) for off in (*walk.span.offs, 0.0)]
    for says, of in ((_("best"), _most), (_("worst"), _least)):
        told = [of(row) for row in rows]
        yield says.ljust(8) + "".join((GONE if n is None else str(n)).rjust(6) for n in told)


def _title(walk: Walk, place: HardPlace) -> str:
    """Return what a hard place is, and which result has the fewest digits there."""
    language = walk.sheet.scene.language
    _ = speaking(language)
    rows = [_near(walk, place, off) for off in walk.span.offs]
    sums = np.nansum([np.min(row, axis=1) for row in rows], axis=0)
    return _(
        "{at}: {why}; worst: {it}",
        at=walk.span.at(walk.span.value(place.at, language)),
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
        return _("the range of the drive ends")
    touches = place.kind == "sharp" and place.times > TOUCHES and bool(place.step.op.gaps)
    kind, place_in_view = "touching" if touches else "undrawn", step_number(log, place.step)
    why = reason(Finding(kind, place.step, place_in_view, (), 0.0), walk.sheet.project, language)
    if place.kind == "end":
        return _("the range of the drive ends: {why}", why=why)
    if place.times > TOUCHES:
        return why
    return _(
        "rounding is magnified {times} times, not far from this: {why}",
        times=number(place.times, language, 2),
        why=why,
    )


def _owner(one: Result) -> str:
    return str(one.row.key[0]) if isinstance(one.row.key, tuple) else str(one.row.key)
