"""Which conditions the teeth of a train that is given break, in words."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.chapters.trains.record import BESIDE, locks
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

LOCKED = said(
    "the train locks itself when {member} drives: losses take more power than is put in; let the other "
    "shaft drive, or take another scheme"
)

STILL = said("with these speeds {member}, which is driven, stands still: no share of 0 can be told")

GAINS = said(
    "the efficiency comes out at {eta:.4g}, more than 1: angular velocities are read off too roughly; write "
    "a finer ruler in [hand]"
)


def failures(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield each condition that is broken, or holds by a shift, a sentence each."""
    made, _ = PLANETARY_PLAN.on(drawn), speaking(language)
    for verdict in check(made.order, made.train):
        if verdict.noteworthy:
            yield _(verdict.text)
    if made.rates.difference is None:
        yield _(STILL, member=made.motion.driven)
    share = BESIDE.on(drawn).efficiency
    if share is not None and (eta := round(float(drawn.value(share)), 3)) > 1.0:
        yield _(GAINS, eta=eta)
    if locks(drawn):
        yield _(LOCKED, member=made.motion.first)


WARNINGS = Warned(failures)
