"""What a scene gives of loads and friction, as the sheet of a task lists it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from graphic_tmm.chapters.forces.task import ASKED, Load
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import SIZE, Given
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield the loads, the largest of one that varies, and the coefficients and pins of friction."""
    order = ASKED.of(scene)
    if order is None:
        return
    for letter, load in zip(letters(order.loads), order.loads, strict=True):
        sizes = sizes_of(load)
        unit = "N·m" if load.point is None else "N"
        if varies(load):
            yield Given(braced(letter, "max"), max(sizes, key=abs), unit)
        else:
            yield Given(letter, sizes[0], unit)
    if order.friction is not None:
        yield from _by_pair("f", order.friction.f, "")
        radii = {name: radius for name, radius in order.friction.radius.items() if radius}
        yield from _by_pair("r", radii, SIZE)


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell what acts on the links besides loads, and in which positions forces are wanted."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    if order.gravity and order.inertia:
        yield _(_BOTH)
    elif order.gravity or order.inertia:
        yield _(_WEIGHT if order.gravity else _INERTIA)
    if told := wanted_positions(scene, language):
        yield told


def wanted_positions(scene: Scene, language: str) -> str:
    """Tell in which positions forces are wanted; "" if in all of them."""
    order = ASKED.of(scene)
    if order is None or order.positions == ("all",):
        return ""
    return speaking(language)(_POSITIONS, n=len(order.positions), listed=", ".join(order.positions))


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


def letters(loads: tuple[Load, ...]) -> list[str]:
    """Return the letters of loads as they stand in the log: F_5; of a second one on its link F_{5(2)}."""
    count, found = Counter[str](), []
    for load in loads:
        letter = f"{'M' if load.point is None else 'F'}_{load.link}"
        count[letter] += 1
        many = count[letter]
        found.append(letter if many == 1 else f"{letter[:2]}{{{load.link}({many})}}")
    return found


def braced(letter: str, more: str = "") -> str:
    """Return a letter with its index in braces, and something behind it: F_5 -> F_{5max}."""
    stem, _, index = letter.partition("_")
    return f"{stem}_{{{index.strip('{}')}{more}}}"


def varies(load: Load) -> bool:
    """Whether the size of a load is another at other positions."""
    return load.travel is not None or bool(load.by_angle) or isinstance(load.size, tuple)


def sizes_of(load: Load) -> tuple[float, ...]:
    """Return the sizes that are given of a load, N or N·m."""
    if load.travel is not None:
        return tuple(size for _, size in (*load.travel.out, *load.travel.back)) or (0.0,)
    if load.by_angle:
        return tuple(size for _, size in load.by_angle)
    return load.size if isinstance(load.size, tuple) else (load.size,)
