"""How accurate forces are: what balances the crank; with friction it is known after many passes only."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Effect, Quantity, Reference, Value
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ASKED, FORCES, Load
from graphic_tmm.chapters.indicator.accuracy import BELOW, at_count, one_sided, two_sided
from graphic_tmm.chapters.kinematics.accuracy import renamed, resampled
from graphic_tmm.chapters.kinematics.plan import ALL
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

PASSES = (2, 3, 4, 6, 8)
"""Numbers of passes of friction that are held against those that have settled."""
SETTLED = 12
"""Passes of friction after which nothing changes any more."""
FORCE, MOMENT, TOOL, REACTIONS = "P_bal", "M_bal", "P_tool", "R"


def _quantities(project: Project) -> Iterator[Quantity]:
    made = FORCES_PLAN.on(project)
    unit = "N·m" if made.order.balance == "moment" else "N"
    # of the last pass of friction, whether passes have settled or not: a hand that slips scatters more
    found = [*zip(_balances(project.scene), (one.balance for one in made.driven), strict=True)]
    if made.tool is not None:
        unit, found = "N", [(TOOL, made.tool.force.value)]
    for name, mark in reversed(found):  # the last is the main one: that of the drive of the row
        value = (Value(mark),)
        if made.order.friction is None:
            yield Quantity(name, unit, value, project.count, due=value)
        else:
            yield Quantity(name, unit, value, project.count, reference=Reference(_many))


def _balances(scene: Scene) -> tuple[str, ...]:
    """Return what the balances of drives are called; of several each bears the number of its link."""
    order, mechanism = ASKED.of(scene), scene.mechanism
    if order is None or mechanism is None:
        return ()
    name = MOMENT if order.balance == "moment" else FORCE
    drives = mechanism.drives
    return tuple(f"{name}_{drive.link}" for drive in drives) if len(drives) > 1 else (name,)


def _called(name: str, speech: Speech) -> str:
    """Return what the balance of one of several drives is called, or what its letter means."""
    stem, _, link = name.rpartition("_")
    meant = stem.removeprefix("letter ")
    if meant not in (FORCE, MOMENT):
        return ""
    return speech(_MEANT if meant != stem else _OF_DRIVE, balance=speech(WORDS[meant]), link=link)


def _many(scene: Scene) -> Scene | None:
    return next((found for _, found in _by_passes(scene, (SETTLED,))), None)


def _by_passes(scene: Scene, passes: tuple[int, ...] = PASSES) -> Iterator[tuple[str, Scene]]:
    order = ASKED.of(scene)
    if order is not None and order.friction is not None:
        for n in passes:
            friction = replace(order.friction, passes=n)
            yield str(n), ASKED.put(scene, replace(order, friction=friction))


def _kept(project: Project) -> tuple[Mark, ...]:
    """Return how many times the lever is larger than the plan, and to what scale groups are drawn."""
    made = FORCES_PLAN.on(project)
    return (*(one.lever.times for one in made.balanced), *(figure.mu for figure in made.figures))


def _whole(scene: Scene) -> Scene:
    order = ASKED.of(scene)
    return scene if order is None else ASKED.put(scene, replace(order, positions=ALL))


def _at_count(scene: Scene, count: int) -> Scene | None:
    order = ASKED.of(scene)
    if order is None:
        return scene
    positions = renamed(order.positions, scene.row, count)
    if positions is None:
        return None
    loads = tuple(
        replace(load, size=resampled(load.size, count)) if isinstance(load.size, tuple) else load
        for load in order.loads
    )
    gas = at_count(order.gas, count) if order.gas is not None else None
    return ASKED.put(scene, replace(order, positions=positions, loads=loads, gas=gas))


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None or order.mu is None:
        return scene
    return ASKED.put(scene, replace(order, mu=order.mu / times))


def _reactions(project: Project) -> Iterator[Quantity]:
    """Yield the sizes of all reactions in the pairs, of the last pass of friction."""
    values = tuple(Value(reaction.value) for reaction in FORCES_PLAN.on(project).reactions)
    yield Quantity(REACTIONS, "N", values, project.count, due=values)


def _effects(scene: Scene) -> Iterator[Effect]:
    order = ASKED.of(scene)
    if order is None:
        return
    yield Effect(said("gravity"), partial(_changed, gravity=False), order.gravity)
    yield Effect(said("inertia"), partial(_changed, inertia=False, single=()), order.inertia)
    if order.gravity or order.inertia:
        yield from masses(scene)
    gas = order.gas is not None
    yield Effect(said("gas"), partial(_changed, gas=None), gas)
    if order.gas is not None and two_sided(order.gas):
        yield Effect(BELOW, partial(_changed, gas=one_sided(order.gas)))
    friction = order.friction is not None
    yield Effect(said("friction"), partial(_changed, friction=None), friction)
    for k, load in enumerate(order.loads):
        place = said("load {n}, at {point}", n=k + 1, point=load.point)
        if load.point is None:
            place = said("load {n}, on link {link}", n=k + 1, link=load.link)
        yield Effect(place, partial(_unloaded, load=load))

    for spring in order.springs:
        name = said("spring {ends}", ends="".join(spring.between))
        left = tuple(one for one in order.springs if one is not spring)
        yield Effect(name, partial(_changed, springs=left))


def _changed(scene: Scene, **changes: Any) -> Scene:
    order = ASKED.of(scene)
    return scene if order is None else ASKED.put(scene, replace(order, **changes))


def _unloaded(scene: Scene, load: Load) -> Scene:
    """Return the scene without one of its loads; another that says the same stays."""
    order = ASKED.of(scene)
    loads = order.loads if order is not None else ()
    return _changed(scene, loads=tuple(one for one in loads if one is not load))


def masses(scene: Scene) -> Iterator[Effect]:
    """Yield, for each link that has a mass or a moment of inertia, that it has them."""
    for link in scene.mechanism.links if scene.mechanism is not None else ():
        if link.mass or link.inertia:
            name = said("masses of link {link}", link=link.number)
            yield Effect(name, partial(_weightless, number=link.number))


def _weightless(scene: Scene, number: int) -> Scene:
    if scene.mechanism is None:
        return scene
    links = tuple(
        replace(link, mass=None, inertia=None) if link.number == number else link
        for link in scene.mechanism.links
    )
    return replace(scene, mechanism=replace(scene.mechanism, links=links))


WORDS = {
    FORCE: said("P_bal"),
    MOMENT: said("M_bal"),
    REACTIONS: said("reaction"),
    f"letter {FORCE}": said("the force on the crank pin that balances the crank"),
    f"letter {MOMENT}": said("the moment that balances the crank"),
    "passes": said("passes of friction"),
}
"""What is told of by name, in English."""
_OF_DRIVE = said("{balance} of link {link}")
_MEANT = said("what balances link {link}, which is driven")

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(FORCES,),
    axes=(Axis("passes", _by_passes, _balances),),
    kept=_kept,
    effects=_effects,
    affected=_reactions,
    enlarged=_enlarged,
    words=WORDS,
    called=_called,
)


FINER = FinerRow(
    whole=_whole,
    at_count=_at_count,
)
