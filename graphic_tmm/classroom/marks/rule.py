"""The teacher's rule, exact and in words: what of 100 points is lost, which mark they make."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import floor
from typing import NamedTuple

from graphic_tmm.checking.report.rows import plan_name, printable_text
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import joined, said

WHOLE = Fraction(100)


class Rule(NamedTuple):
    """A rule; all numbers are fractions. Of 100 points are lost:

    ``wrong`` by a wrong reading, and by all those of a segment no more than ``segment``; ``mistake`` by a
    mistake that is named, but no more than its readings would cost; ``doubtful`` by a doubtful reading that is
    as good as wrong, by another its share of that, by all of them no more than ``doubtful_most``; ``whole`` by
    a drawing that is off as a whole; ``plan`` by a plan that is missing; ``reading`` by a reading that is
    missing in a plan that is not; ``variant`` by a hand-in that fits another variant than its own.

    The mark: by ``steps``, each a name and from how many points on it is given, the best first, ``below`` them
    the last; or, where there are none, in proportion from ``lowest`` (0 points) to ``scale`` (100), rounded to
    a multiple of ``round``, a half up. ``plans``: the plans that are asked for; none: those that the scene's
    short template asks for.
    """

    scale: Fraction = Fraction(5)
    lowest: Fraction = Fraction(2)
    round: Fraction = Fraction(1)
    steps: tuple[tuple[str, Fraction], ...] = ()
    below: str = ""
    wrong: Fraction = Fraction(4)
    segment: Fraction = Fraction(10)
    mistake: Fraction = Fraction(16)
    doubtful: Fraction = Fraction(4)
    doubtful_most: Fraction = Fraction(8)
    whole: Fraction = Fraction(16)
    plan: Fraction = Fraction(25)
    reading: Fraction = Fraction(2)
    variant: Fraction = Fraction(51)
    plans: tuple[str, ...] = ()


FIVE = Rule(steps=(("5", Fraction(85)), ("4", Fraction(70)), ("3", Fraction(50))), below="2")
"""The rule where no other is given: marks from 2 to 5."""

Segment = tuple[str, str]
"""Plan and segment."""


class Faults(NamedTuple):
    """What counts in a hand-in.

    ``wrong``: of every wrong reading its plan and segment, and by which cause named (a number) it is explained,
    -1 for none; a reading that several explain counts for the first. ``doubtful``: the doubts of all doubtful
    readings together, each up to 1. ``whole``: whether the drawing is off as a whole. ``missing``:
    the plans that are; ``unread``: how many readings are, in those that are not. ``other``: whether the
    readings fit another variant.
    """

    wrong: tuple[tuple[Segment, int], ...] = ()
    doubtful: Fraction = Fraction(0)
    missing: tuple[str, ...] = ()
    unread: int = 0
    other: bool = False
    whole: bool = False


class Mark(NamedTuple):
    """A mark as it is written, and the points that made it."""

    text: str
    points: Fraction


def marked(rule: Rule, faults: Faults) -> Mark:
    """Return the mark of a hand-in."""
    points = max(Fraction(0), WHOLE - sum(losses(rule, faults).values(), Fraction(0)))
    return Mark(mark_of(rule, points), points)


def losses(rule: Rule, faults: Faults) -> Mapping[str, Fraction]:
    """Return how many points are lost by what, by the names of the rule's keys."""
    own = [segment for segment, cause in faults.wrong if cause < 0]
    causes: dict[int, list[Segment]] = {}
    for segment, cause in faults.wrong:
        if cause >= 0:
            causes.setdefault(cause, []).append(segment)
    named = (min(rule.mistake, _apart(rule, one)) for one in causes.values())
    return {
        "wrong": _apart(rule, own),
        "mistake": sum(named, Fraction(0)),
        "doubtful": min(rule.doubtful * faults.doubtful, rule.doubtful_most),
        "whole": rule.whole * faults.whole,
        "plan": rule.plan * len(faults.missing),
        "reading": rule.reading * faults.unread,
        "variant": rule.variant * faults.other,
    }


def _apart(rule: Rule, segments: Sequence[Segment]) -> Fraction:
    """Return what wrong readings of segments cost without a cause that is named."""
    counts = Counter(segments).values()
    return sum((min(rule.wrong * count, rule.segment) for count in counts), Fraction(0))


def mark_of(rule: Rule, points: Fraction) -> str:
    """Return the mark that points make.

    >>> mark_of(FIVE, Fraction(85)), mark_of(FIVE, Fraction(849, 10)), mark_of(FIVE, Fraction(0))
    ('5', '4', '2')
    >>> mark_of(Rule(scale=Fraction(10), lowest=Fraction(0), round=Fraction(1, 2)), Fraction(725, 10))
    '7.5'
    """
    if rule.steps:
        return next((name for name, least in rule.steps if points >= least), rule.below)
    exact = rule.lowest + (rule.scale - rule.lowest) * points / WHOLE
    return decimal(rule.round * floor(exact / rule.round + Fraction(1, 2)))


def decimal(value: Fraction, places: int = 6) -> str:
    """Return a number as it is written: no more decimals than it has, at most so many.

    >>> decimal(Fraction(9, 2)), decimal(Fraction(70)), decimal(Fraction(1, 3), 2), decimal(Fraction(-5, 4))
    ('4.5', '70', '0.33', '-1.25')
    """
    whole = floor(abs(value) * 10**places + Fraction(1, 2))
    text = f"{whole:0{places + 1}d}"
    text = f"{text[:-places]}.{text[-places:]}".rstrip("0").rstrip(".")
    return f"-{text}" if value < 0 and text != "0" else text


def rule_sentences(rule: Rule, language: str, plans: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Return the rule, a sentence each; ``plans``: those that are asked for."""
    return tuple(map(speaking(language), _sentences(rule, language, plans)))


def _sentences(rule: Rule, language: str, plans: tuple[str, ...]) -> Iterator[str]:
    def of(value: Fraction) -> str:
        return decimal(value).replace(".", decimal_sign(language)).replace("-", "−")

    yield said("Everybody begins with 100 points.")
    if rule.wrong:
        yield said(
            "A wrong reading costs {wrong}, all wrong ones of one segment together no more than {segment}; "
            "one that only follows from another is not wrong.",
            wrong=of(rule.wrong),
            segment=of(rule.segment),
        )
        yield said(
            "What a mistake that is named makes wrong costs no more than {mistake} together: a mistake is "
            "punished once.",
            mistake=of(rule.mistake),
        )
    if rule.doubtful and rule.doubtful_most:
        yield said(
            "A doubtful reading costs up to {doubtful}, the more the fewer hands are so far off, all of them "
            "no more than {most}.",
            doubtful=of(rule.doubtful),
            most=of(rule.doubtful_most),
        )
    if rule.whole:
        yield said("A drawing that is off as a whole costs {whole}.", whole=of(rule.whole))
    if plans and (rule.plan or rule.reading):
        listed = joined(", ", (plan_name(plan, language) for plan in plans))
        yield said(
            "A plan that is missing costs {plan}, a reading missing in a plan that is there {reading}. Asked "
            "for are: {listed}.",
            plan=of(rule.plan),
            reading=of(rule.reading),
            listed=listed,
        )
    if rule.variant:
        yield said(
            "Readings that fit another variant than the own one cost {variant}.",
            variant=of(rule.variant),
        )
    if rule.steps:
        rows = (
            said("{mark} from {points}", mark=printable_text(name), points=of(least))
            for name, least in rule.steps
        )
        yield said(
            "The mark by points: {steps}, below that {below}.",
            steps=joined(", ", rows),
            below=printable_text(rule.below),
        )
    else:
        yield said(
            "The mark goes from {lowest} for no points to {scale} for all of them, rounded to {unit}, a half "
            "up.",
            lowest=of(rule.lowest),
            scale=of(rule.scale),
            unit=of(rule.round),
        )
