"""What a task gives of a cylinder: its sizes, its pressures by positions, by points, by polytropic parts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

from graphic_tmm.chapters.indicator.diagram import letter_of
from graphic_tmm.chapters.indicator.task import Gas, IndicatorTask, Stretch
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.drawing import Wanted
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.readers.task_sheet import (
    SIZE,
    Acting,
    Given,
    Listed,
    LoadSign,
    Posed,
    given_figure,
)
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.tasks import SectionKey


def given_of(order: IndicatorTask) -> Iterator[Given]:
    """Yield what is given of cylinders, diameters in mm; their pressures stand in a table by positions."""
    if order.further:
        for one in order.every:
            for given in given_of(replace(one, strokes=2)):
                yield given._replace(symbol=_of(given.symbol, one.point))
        if order.strokes != 2:
            yield Given("strokes of the cycle", order.strokes)
        return
    yield Given("D", order.cover.bore, SIZE)
    sides = [side for side in (order.cover, order.shaft) if side is not None]
    if rod := max(side.rod for side in sides):
        yield Given("d", rod, SIZE)
    yield Given("p_{max}", order.highest, "Pa")
    if clearance := max(side.clearance for side in sides):
        yield Given("c", clearance)
    if order.strokes != 2:
        yield Given("strokes of the cycle", order.strokes)


def _of(symbol: str, point: str) -> str:
    """Return a symbol of one of several cylinders: D_{B}, p_{maxB}."""
    stem, _, index = symbol.partition("_")
    return letter_of(stem, index.strip("{}") + point)


def stated(order: IndicatorTask | None, language: str) -> Iterator[str]:
    """Tell of which of several cylinders the cycle begins later."""
    for one in order.every if order is not None else ():
        if one.phase:
            yield speaking(language)(
                _LATER, point=one.point, angle=given_figure(one.phase, language)
            )


ACROSS = 8
"""So many positions stand beside one another in a table."""
LONG, OFF = 16.0, 6.0
"""How long the arrow of the gas is, and how far off its point it ends, mm."""


def listed(order: IndicatorTask | None, scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the pressures on both sides of the piston."""
    if order is None:
        return
    _ = speaking(language)
    for one in order.every:
        of = _(_CYLINDER, point=one.point) if order.further else ""
        for gas, title in ((one.cover, _COVER), (one.shaft, _SHAFT)):
            if gas is not None:
                yield from _side(scene, gas, ". ".join(filter(None, (of, _(title)))), language)


def _side(scene: Scene, gas: Gas, title: str, language: str) -> Iterator[Listed]:
    _, words, pascal = speaking(language), captions(language), f"p, {unit('Pa', language)}"
    if gas.even:
        parts = [part.pressure for part in gas.stretches]
        level = given_figure((*gas.pressures, *parts)[0], language)
        yield Listed("pressure", title, (pascal,), ((level,),))
        return
    for k in range(0, len(gas.pressures), ACROSS):
        some = gas.pressures[k : k + ACROSS]
        heads = (words["position"], *(str(scene.row.first + k + n) for n in range(len(some))))
        row = (pascal, *(given_figure(p, language) for p in some))
        yield Listed(f"pressures-{k}", "" if k else title, heads, (row,))
    if gas.stretches:
        heads = tuple(map(_, (_STROKE, _FROM, _TO, _LAW)))
        rows = tuple(_stretch(one, language) for one in gas.stretches)
        yield Listed("pressures", title, (*heads, pascal), rows)


def _stretch(one: Stretch, language: str) -> tuple[str, ...]:
    _ = speaking(language)
    way = _(_OUT if one.stroke == "out" else _BACK)
    spots = given_figure(one.start, language), given_figure(one.end, language)
    if one.exponent is None:
        size = f"{given_figure(one.pressure, language)} … {given_figure(one.last, language)}"
        return (way, *spots, _(_STRAIGHT), size)
    law = (
        "p = const"
        if not one.exponent
        else f"pV^{{{given_figure(one.exponent, language)}}} = const"
    )
    return (way, *spots, law, given_figure(one.pressure, language))


_LATER = said("The cycle of cylinder {point} begins {angle}° later than at its first dead centre.")
_CYLINDER = said("Cylinder {point}")
_COVER = said("Pressures on the side of the piston away from the crank")
_SHAFT = said("Pressures on the side of the piston towards the crank")
_STROKE = said("Stroke", context="of a piston")
_FROM, _TO, _LAW = said("from s/S"), said("to s/S"), said("Pressure by")
_OUT, _BACK = said("from the cover"), said("to the cover")
_STRAIGHT = said("straight line")


def acting(order: IndicatorTask | None, scene: Scene, posed: Posed) -> Iterator[Acting]:
    """Yield the force of the gas on the piston, from the cover, as an arrow at the piston."""
    for one in order.every if order is not None else ():
        letter = letter_of("P", one.point) if order is not None and order.further else "P"
        yield from _pushing(one, letter, scene, posed)


def _pushing(order: IndicatorTask, letter: str, scene: Scene, posed: Posed) -> Iterator[Acting]:
    mechanism = scene.mechanism
    if mechanism is None:
        return
    link = next((one for one in mechanism.links if order.point in one.points and one.slides), None)
    if link is None:
        return
    at, going = posed.spot(order.point, link.number)
    pivot, _ = posed.spot(dissect(mechanism).origin, mechanism.frame.number)
    if not going:
        return
    inward = going if ((pivot - at) * going.conjugate()).real > 0.0 else -going
    owner = mechanism.by_number[link.slides[0].on]
    if owner is not mechanism.frame:
        pin = next((k for k in owner.points if k in mechanism.frame.points), None)
        if pin is None:
            return
        from_pin = at - posed.spot(pin, owner.number)[0]
        inward = from_pin / abs(from_pin)
    tail = at - (LONG + OFF) * inward
    strokes = tuple(one._replace(part="load") for one in arrow(tail, at - OFF * inward, "main"))
    wanted = Wanted(letter, tail, posed.size, 1.5, -inward)
    yield Acting(strokes, (wanted,), LoadSign(letter, at, inward, pushes=True))


class GasOf(NamedTuple):
    """What a task sheet says of the gas of a section of a scene that has an ``indicator``."""

    asked: SectionKey[Any]

    def _order(self, scene: Scene) -> IndicatorTask | None:
        order = self.asked.of(scene)
        found: IndicatorTask | None = order.indicator if order is not None else None
        return found

    def stated(self, scene: Scene, language: str) -> Iterator[str]:
        """Tell which cylinders begin their cycle later."""
        return stated(self._order(scene), language)

    def listed(self, scene: Scene, language: str) -> Iterator[Listed]:
        """Yield the pressures in the cylinders."""
        return listed(self._order(scene), scene, language)

    def acting(self, scene: Scene, posed: Posed) -> Iterator[Acting]:
        """Yield the force of the gas."""
        return acting(self._order(scene), scene, posed)
