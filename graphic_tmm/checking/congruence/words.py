"""What is said first of a drawing: in which scale factors it was judged, what was turned, its unit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.checking.congruence.moves import MOVES, Move
from graphic_tmm.checking.records import OwnScale
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import unit as unit_name
from graphic_tmm.scene.captions import view_name

DOWN = Move(0, mirrored=True)
_DIGITS = 4
_UNITS = {"cm": said("centimetres"), "inch": said("inches")}
_WHY = {
    "stated": said("as stated, or as clicks show it"),
    "rows": said("mm and values of {agree} rows of {count} say it"),
    "rates": said("your rates and lengths say it in {agree} positions of {count}"),
    "supposed": said("so the lengths fit, with the mistake that is named"),
}
"""Why a scale factor is somebody's own, where that is decided."""


def head(
    scales: Sequence[OwnScale], moves: Mapping[str, Move], units: Mapping[str, str], language: str
) -> tuple[str, ...]:
    """Return the sentences on how a drawing was judged."""
    speech = speaking(language)
    return tuple(speech(one) for one in _sentences(scales, moves, units, language))


def _sentences(
    scales: Sequence[OwnScale], moves: Mapping[str, Move], units: Mapping[str, str], language: str
) -> Iterator[Said]:
    own = [one for one in scales if one.by in _WHY and one.mu != one.due]
    if own:
        told = joined("; ", [_own(one, language) for one in own])
        yield said("Judged in your own scale factors: {told}.", told=told)
    unsure = [one for one in scales if one.by in ("round", "lengths")]
    if unsure:
        yield _question(unsure, language)
    for one in scales:
        if one.against != (1.0, 1.0):
            yield _stated(one, language) if one.by == "stated" else _against(one, language)
    yield from _moved(moves, language)
    for unit in dict.fromkeys(units.values()):
        plans = ", ".join(view_name(plan, language) for plan, own in units.items() if own == unit)
        yield said(
            "{plans}: the lengths were written in {unit}, not in mm; they are judged as such.",
            plans=plans,
            unit=_UNITS[unit],
        )


def _mu(mu: float, one: OwnScale, language: str) -> str:
    of = unit_name(one.unit.removesuffix("/mm").strip("()"), language)
    of = f"({of})" if "/" in of or "·" in of else of
    return f"{plain(one.symbol)} = {number(mu, language, _DIGITS)} {of}/{unit_name('mm', language)}"


def _own(one: OwnScale, language: str) -> Said:
    places = ""
    if one.places:
        listed = ", ".join(f"{place}: {number(mu, language, _DIGITS)}" for place, mu in one.places)
        places = f" ({listed})"
    return said(
        "{plan}, {mu}{places}, where the task has {due} ({why})",
        plan=view_name(one.view, language),
        mu=_mu(one.mu, one, language),
        places=places,
        due=number(one.due, language, _DIGITS),
        why=said(_WHY[one.by], agree=one.agree, count=one.among),
    )


def _question(scales: Sequence[OwnScale], language: str) -> Said:
    """Return what nothing but lengths says of scale factors, and what to do about it, once for all plans."""
    factors: dict[tuple[str, float, float], list[OwnScale]] = {}
    for one in scales:
        factors.setdefault((one.symbol, one.mu, one.due), []).append(one)
    told = [_scale_of(same, language) for same in factors.values()]
    laid = ", ".join(dict.fromkeys(one.first for one in scales if one.first))
    return said(
        "Drawn to scale factors of your own? {told}. Only lengths say so: if you took these, the lengths are "
        "right; if you took those of the task, they are wrong, and what is laid off first{laid} is to be "
        "looked at. Write your μ into the readings.",
        told=joined("; ", told),
        laid=f" ({laid})" if laid else "",
    )


def _scale_of(same: Sequence[OwnScale], language: str) -> Said:
    return said(
        "{plan}: {mu}, where the task has {due} (lengths {times} times as long as due)",
        plan=", ".join(view_name(one.view, language) for one in same),
        mu=_mu(same[0].mu, same[0], language),
        due=number(same[0].due, language, _DIGITS),
        times=number(same[0].due / same[0].mu, language, 3),
    )


def _stated(one: OwnScale, language: str) -> Said:
    return said(
        "{plan}: you state {mu}, but your figures were calculated with {own}.",
        plan=view_name(one.view, language),
        mu=_mu(one.mu, one, language),
        own=number(one.due / one.against[1], language, _DIGITS),
    )


def _against(one: OwnScale, language: str) -> Said:
    lengths, rates = (number(times, language, 3) for times in one.against)
    if rates == "1":
        return said(
            "{plan}: the lengths are {lengths} times as long as due, but your rates were calculated with the "
            "task's scale factor: it is no scale factor of your own, {first} was laid off wrongly.",
            plan=view_name(one.view, language),
            lengths=lengths,
            first=one.first or said("what is laid off first"),
        )
    return said(
        "{plan}: the lengths are {lengths} times as long as due, but your rates were calculated with a scale "
        "factor of {rates} times the task's: it is no scale factor of your own, {first} was laid off wrongly.",
        plan=view_name(one.view, language),
        lengths=lengths,
        rates=rates,
        first=one.first or said("what is laid off first"),
    )


def _moved(moves: Mapping[str, Move], language: str) -> Iterator[Said]:
    by_move: dict[Move, list[str]] = {}
    for plan, move in moves.items():
        by_move.setdefault(move, []).append(view_name(plan, language))
    for move, plans in by_move.items():
        if move == Move(0):
            yield said(
                "The points are counted from an origin of their own, not from the pole ({plans}).",
                plans=", ".join(plans),
            )
            continue
        yield said(
            "The points are taken {how} ({plans}), and are judged so.",
            how=MOVES[move],
            plans=", ".join(plans),
        )
        if move == DOWN and len(plans) > 1:
            yield said("Or the crank was turned the other way: these points do not tell which.")
