"""A rule in words, for people who get marks by it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from graphic_tmm.checking.report.rows import plan_name, shown
from graphic_tmm.classroom.marks.rule import Rule, decimal
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import joined, said


def told(rule: Rule, language: str, plans: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Return the rule, a sentence each; ``plans``: those that are asked for."""
    return tuple(map(speaking(language), _told(rule, language, plans)))


def _told(rule: Rule, language: str, plans: tuple[str, ...]) -> Iterator[str]:
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
            "A doubtful reading costs {doubtful}, all of them no more than {most}.",
            doubtful=of(rule.doubtful),
            most=of(rule.doubtful_most),
        )
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
            said("{mark} from {points}", mark=shown(name), points=of(least))
            for name, least in rule.steps
        )
        yield said(
            "The mark by points: {steps}, below that {below}.",
            steps=joined(", ", rows),
            below=shown(rule.below),
        )
    else:
        yield said(
            "The mark goes from {lowest} for no points to {scale} for all of them, rounded to {unit}, a half "
            "up.",
            lowest=of(rule.lowest),
            scale=of(rule.scale),
            unit=of(rule.round),
        )
