"""What is found of forces: nothing to compare, polygons of no forces; which digits of a difference are sure."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import needed
from graphic_tmm.board.findings import Finding, step_number
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.wheels import SolvedWheel
from graphic_tmm.chapters.kinematics.bodies import Meshed
from graphic_tmm.chapters.kinematics.findings import assumed
from graphic_tmm.drawn import Drawn, Findings
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.findings import Warned


def balanced(project: Project, doubts: Doubts) -> dict[int, np.ndarray]:
    """Return, by the slot of their difference, where both methods find that nothing balances a drive.

    There is nothing to compare then.
    """
    made = FORCES_PLAN.on(project)
    found = {}
    for one in made.balanced:
        none = doubts.nothing(one.lever.balance)
        if made.tool is None:
            none = none & doubts.nothing(one.balance)
        found[one.difference.slot] = np.broadcast_to(none, (1, len(project.names)))
    return found


def ruled(project: Project, given: Mapping[Mark, object], hand: Hand) -> dict[int, Doubts]:
    """Return what the ruler leaves of the difference of the two methods: its digits follow from readings."""
    if hand.ruler is None:
        return {}
    return {
        mark.slot: Doubts(needed(project.construction, [mark]), given, ruler=hand.ruler)
        for mark in (one.difference for one in FORCES_PLAN.on(project).balanced)
    }


def compared(drawn: Drawn, one: Finding, places: set[int]) -> Finding:
    """Return a finding without what it says of comparing nothing with nothing; its places are cut down."""
    made, doubts = FORCES_PLAN.on(drawn), drawn.doubts
    if one.step.it.view not in made.views:
        return one
    by_slot = balanced(drawn.project, doubts)
    for difference in (other.difference for other in made.balanced):
        nothing = set(np.flatnonzero(by_slot[difference.slot][0]).tolist())
        if one.kind == "undrawn" and one.step.it == difference:
            # of what is lost there is nothing to compare either: that it is lost is told
            lost = [doubts.lost[use.slot] for use in one.step.uses if use.slot in doubts.lost]
            places -= nothing.union(*(np.flatnonzero(mask[0]).tolist() for mask in lost))
        if one.kind == "lost" and places <= nothing:
            one = one._replace(marks=tuple(mark for mark in one.marks if mark != difference))
    return one


def idle(drawn: Drawn) -> Iterator[Finding]:
    """Yield the polygons that have no scale, for all their forces are nothing."""
    made, log = FORCES_PLAN.on(drawn), drawn.construction
    for polygon in made.polygons:
        if polygon.view not in drawn.scales:
            step = next(step for step in log.steps if step.it.view == polygon.view)
            yield Finding("idle", step, step_number(log, step), made.places, 0.0)


FINDINGS = Findings(nothing=balanced, coarse=ruled, compared=compared, findings=idle)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = FORCES_PLAN.on(drawn)
    if made.order.inertia:
        yield from assumed(drawn)
    for solved in (one for one in made.groups if isinstance(one, SolvedWheel)):
        wheel = solved.wheel
        if wheel.span is None:
            continue
        names = drawn.project.names
        draws = drawn.reading[solved.parts[0].value] * _pulls(drawn, wheel)
        draws = np.broadcast_to(draws, (len(draws), len(names)))
        pushed = [names[k] for k in made.places if draws[0, k] < 0.0]
        if pushed:
            yield speaking(language)(
                _PUSHED,
                n=len(pushed),
                of=speaking(language)(_OF.get(wheel.rolling.mesh.by, _OF["belt"])),
                run=wheel.span.letter + wheel.rolling.letter,
                link=wheel.leg.link,
                listed=", ".join(pushed),
            )


def _pulls(drawn: Drawn, wheel: Meshed) -> Reals:
    """Return the sign across its radius of a force by which the run of a belt that is drawn pulls."""
    assert wheel.span is not None
    radius, run = drawn.reading[wheel.leg.line], drawn.reading[wheel.span.line]
    return np.asarray(-(run.along / radius.along).imag)


_OF = {"belt": said("of the belt"), "chain": said("of the chain")}
_PUSHED = said(
    "in position {listed} the run {run} {of} would push link {link}: the other run pulls there, and the "
    "reactions of the pins are not those drawn; the balance is",
    "in positions {listed} the run {run} {of} would push link {link}: the other run pulls there, and "
    "the reactions of the pins are not those drawn; the balance is",
)


WARNINGS = Warned(_warnings)
