"""What a task gives of loads and friction, and what it states of them in words."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from graphic_tmm.chapters.forces.kinds import AGAINST, Along
from graphic_tmm.chapters.forces.load_diagrams import braced, letters, sizes_of, varies
from graphic_tmm.chapters.forces.loads import Ends
from graphic_tmm.chapters.forces.springs import constants, ends_of, numbers
from graphic_tmm.chapters.forces.task import ASKED, Load, Spring, Unknown
from graphic_tmm.chapters.forces.tool import letter_of
from graphic_tmm.chapters.indicator.given import given_of
from graphic_tmm.chapters.indicator.given import stated as cylinders
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.readers.task_sheet import SIZE, Given, given_figure
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield the loads, the largest of one that varies, and the coefficients and pins of friction."""
    order = ASKED.of(scene)
    if order is None:
        return
    meshes = scene.mechanism.meshes if scene.mechanism is not None else ()
    yield from dict.fromkeys(Given("α_w", m.pressure, "°") for m in meshes if not m.belted)
    for letter, load in zip(letters(order.loads), order.loads, strict=True):
        sizes = sizes_of(load)
        unit = "N·m" if load.point is None else "N"
        if varies(load):
            yield Given(braced(letter, "max"), max(sizes, key=abs), unit)
        else:
            yield Given(letter, sizes[0], unit)
    for index, spring in zip(numbers(order.springs), order.springs, strict=True):
        yield from _given_of(spring, index)
    if order.gas is not None:
        yield from given_of(order.gas)
    if order.friction is not None:
        yield from _by_pair("f", order.friction.f, "")
        radii = {name: radius for name, radius in order.friction.radius.items() if radius}
        yield from _by_pair("r", radii, SIZE)


def _ends(scene: Scene, spring: Spring) -> Ends:
    assert scene.mechanism is not None
    return ends_of(spring, scene.mechanism)


def _given_of(spring: Spring, index: str) -> Iterator[Given]:
    told = (spring.rate, spring.free, spring.force or None, spring.damping)
    units = ("N/m", SIZE, "N", "N·s/m")
    for letter, value, unit in zip(constants(index), told, units, strict=True):
        if value is not None:
            yield Given(letter, value, unit)


def _springs(scene: Scene, springs: tuple[Spring, ...], language: str) -> Iterator[str]:
    """Tell the ends of springs and what their forces are."""
    for index, spring in zip(numbers(springs), springs, strict=True):
        ends = _ends(scene, spring)
        (first, last), name = ends.letters, ends.names[0]
        words = {"first": first, "last": last, "letter": f"F_{name}", "ends": name}
        yield speaking(language)(_SPRING, law=_law(spring, index), **words)


def _law(spring: Spring, index: str) -> str:
    """Return the force of a spring as plain text: c·(l − l_0) + F_0 + b·dl/dt."""
    rate, free, preload, damping = map(plain, constants(index))
    terms = [f"{rate}·(l − {free})"] if spring.rate is not None else []
    terms += [preload] if spring.force else []
    terms += [f"{damping}·dl/dt"] if spring.damping is not None else []
    return " + ".join(terms)


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell what acts on the links besides loads, and in which positions forces are wanted."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    for letter, load in zip(letters(order.loads), order.loads, strict=True):
        if load.point is not None and load.direction != AGAINST:
            yield _acts(load, load.point, plain(symbol(letter, language)), language)
        if isinstance(load.direction, Along):
            yield _turning(load.direction, plain(symbol(letter, language)), language)
        if load.opposite is not None:
            told, other = plain(symbol(letter, language)), load.opposite
            says = _ON_LINE if load.opposite_at is None else _AT_POINT
            says = _TURNS if load.point is None else says
            at = load.opposite_at or ""
            yield _(says, letter=told, link=load.link, other=other, point=at)
    yield from _springs(scene, order.springs, language)
    yield from cylinders(order.gas, language)
    if order.unknown is not None:
        yield _sought(order.unknown, language)
    if order.gravity and order.inertia:
        yield _(_BOTH)
    elif order.gravity or order.inertia:
        yield _(_WEIGHT if order.gravity else _INERTIA)
    if told := wanted_positions(scene, language):
        yield told


def _acts(load: Load, point: str, letter: str, language: str) -> str:
    """Tell where a force acts, and how it is directed if that stays."""
    _, at = speaking(language), {"letter": letter, "point": point, "link": str(load.link)}
    if isinstance(load.direction, float):
        return _(_AT_ANGLE, angle=given_figure(load.direction, language), **at)
    return _(_AT, **at)


def _sought(unknown: Unknown, language: str) -> str:
    """Tell the force that is sought at a tool, and how it is directed."""
    letter, way = plain(letter_of(unknown)), unknown.direction
    told = speaking(language)(_SOUGHT, letter=letter, link=unknown.link, point=unknown.point)
    if isinstance(way, Along):
        by = way.by % 360.0
        line = speaking(language)(_LINE, letter=letter, line=way.line)
        return f"{told} {line if by == 0.0 else _turning(way, letter, language)}"
    angle = given_figure(float(way), language)
    return f"{told} {speaking(language)(_FIXED, letter=letter, angle=angle)}"


def wanted_positions(scene: Scene, language: str) -> str:
    """Tell in which positions forces are wanted; "" if in all of them."""
    order = ASKED.of(scene)
    if order is None or order.positions == ("all",):
        return ""
    return speaking(language)(_POSITIONS, n=len(order.positions), listed=", ".join(order.positions))


def _turning(along: Along, letter: str, language: str) -> str:
    """Tell the direction of a load that turns with the links."""
    _, by = speaking(language), along.by % 360.0
    says = {0.0: _ALONG, 90.0: _SQUARE}.get(by, _ANGLE)
    return _(says, letter=letter, line=along.line, angle=given_figure(along.by, language))


_SPRING = said(
    "The force {letter} = {law} pulls {first} and {last} together (where it is negative, apart); l is the "
    "length {ends}."
)
_AT = said("{letter} acts at {point} of link {link}.")
_AT_ANGLE = said("{letter} acts at {point} of link {link}, at the angle {angle}° to the x axis.")
_ON_LINE = said(
    "{letter} is what link {other} does to link {link}; the opposite force acts on link {other}, on the same "
    "line."
)
_AT_POINT = said(
    "{letter} is what link {other} does to link {link}; the opposite force acts at {point} of link {other}."
)
_TURNS = said(
    "{letter} is what link {other} does to link {link}; the opposite moment acts on link {other}."
)
_ALONG = said("The direction of {letter} turns with the mechanism: it acts along {line}.")
_SQUARE = said(
    "The direction of {letter} turns with the mechanism: {line} turned by 90° counter-clockwise."
)
_ANGLE = said(
    "The direction of {letter} turns with the mechanism: {line} turned by {angle}° counter-clockwise."
)
_SOUGHT = said(
    "The force {letter} is sought that has to act on link {link} at {point} for the given loads to be balanced."
)
_LINE = said("{letter} acts along {line}.")
_FIXED = said("{letter} acts at {angle}° to the x axis.")
_BOTH = said("Weights and inertia forces of the links are taken into account.")
_WEIGHT = said("Weights of the links are taken into account, inertia forces are not.")
_INERTIA = said("Inertia forces of the links are taken into account, weights are not.")
_POSITIONS = said(
    "Forces are wanted in position {listed}.", "Forces are wanted in positions {listed}."
)


def _by_pair(letter: str, values: Mapping[str, float], unit: str) -> Iterator[Given]:
    """Yield the value of every pair; one that most of them have is told once for all that are not named."""
    if not values:
        return
    (most, times), *_ = Counter(values.values()).most_common(1)
    if times > 1:
        yield Given(letter, most, unit)
    for name, value in values.items():
        if times == 1 or value != most:
            yield Given(f"{letter}_{{{name}}}", value, unit)
