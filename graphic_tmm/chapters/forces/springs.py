"""Springs and dampers between two links: by the length read on the plan, and by how fast that changes."""

from __future__ import annotations

from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.instruments import (
    join,
    measure,
    measure_along,
    parallel,
    square,
)
from graphic_tmm.board.operations.statics import reversed_
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.given_loads import free_letter
from graphic_tmm.chapters.forces.kinds import ends_on
from graphic_tmm.chapters.forces.loads import Ends, Force, Ground, Sprung, point_of
from graphic_tmm.chapters.forces.operations import damper_force, preloaded_force, spring_force
from graphic_tmm.chapters.forces.task import Spring
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism


def ends_of(spring: Spring, mechanism: Mechanism) -> Ends:
    """Return the ends of a spring.

    Raises
    ------
    StructureError
        If they are not on two links.
    """
    bodies = {number: link.points for number, link in mechanism.by_number.items()}
    links = ends_on(spring.between, spring.links, bodies)
    if links is None:
        says = said("both ends are on one link: it moves nothing; name letters of two links")
        raise StructureError(says, "between", head="spring")
    if links[0] == mechanism.frame.number:
        return Ends(spring.between[::-1], links[::-1])
    return Ends(spring.between, links)


def numbers(springs: tuple[Spring, ...]) -> list[str]:
    """Return the indices of what springs are given by: numbers, "" of a single one."""
    return [str(k) if len(springs) > 1 else "" for k in range(1, len(springs) + 1)]


def constants(index: str) -> tuple[str, str, str, str]:
    """Return the letters of what a spring is given by: stiffness, free length, force there, damping.

    >>> constants(""), constants("2")
    (('c', 'l_0', 'F_0', 'b'), ('c_2', 'l_{02}', 'F_{02}', 'b_2'))
    """
    if not index:
        return "c", "l_0", "F_0", "b"
    return f"c_{index}", f"l_{{0{index}}}", f"F_{{0{index}}}", f"b_{index}"


def draw_spring(ground: Ground, spring: Spring, index: str) -> tuple[Sprung, list[Force]]:
    """Record a spring; return it as drawn, and the forces with which it pulls its ends together."""
    draft, ends = ground.draft, ends_of(spring, ground.mechanism)
    (start, image), (end, other) = (
        point_of(ground, link, letter)
        for letter, link in zip(ends.letters, ends.links, strict=True)
    )
    letter, back = (free_letter(ground, "F", index) for index in ends.indices)
    line = draft.draw(join, f"({letter})", start, end, why=why.SPRING_LINE)
    length = pull = held = None
    whole = spring.damping is None
    if spring.rate is not None:
        length = draft.draw(measure, ends.names[0], start, end, why=why.SPRING_LENGTH)
        pull = _pull(ground, spring, index, length, letter if whole else f"{letter}^{{c}}")
    elif spring.force:
        pull = draft.take(Number, letter if whole else f"{letter}^{{c}}", spring.force, "N")
    if spring.damping is not None:
        told = letter if pull is None else f"{letter}^{{b}}"
        held = _held(ground, spring.damping, (image, other), line, index, told)
    value = pull if held is None else held
    if pull is not None and held is not None:
        value = draft.draw(added, letter, pull, held, unit="N", why=why.SPRING_AND_DAMPER)
    assert value is not None, "a spring that does nothing"
    forces = [Force(letter, ends.links[0], start, line, value, image)]
    if ends.links[1] != ground.mechanism.frame.number:
        across = draft.draw(parallel, f"({back})", end, line, sense=1, why=why.OPPOSITE_LINE)
        reverse = draft.draw(reversed_, back, value, unit="N")
        forces.append(Force(back, ends.links[1], end, across, reverse, other))
    return Sprung(spring, ends, length, pull if length is not None else None, index), forces


def _pull(ground: Ground, spring: Spring, index: str, length: Mark, letter: str) -> Mark:
    """Calculate the force of the spring alone, by its length."""
    draft, (c, l_0, f_0, _) = ground.draft, constants(index)
    assert spring.rate is not None
    assert spring.free is not None
    rate = draft.constant(c, spring.rate, "N/m")
    free = draft.constant(l_0, spring.free, "m")
    if not spring.force:
        return draft.draw(spring_force, letter, rate, length, draft.mu_l, free, unit="N")
    preload = draft.constant(f_0, spring.force, "N")
    return draft.draw(preloaded_force, letter, rate, length, draft.mu_l, free, preload, unit="N")


def _held(
    ground: Ground, damping: float, images: tuple[Mark, Mark], line: Mark, index: str, letter: str
) -> Mark:
    """Calculate the force of the damper, by the part of the relative velocity along it."""
    draft, plan, (first, last) = ground.draft, ground.velocities, images
    name = f"{first.letter}{last.letter}"
    along = line
    if ground.quarters:
        sense = -ground.quarters
        along = draft.draw(square, f"({name})", first, line, sense=sense, why=why.RATE_LINE)
    rate = draft.draw(measure_along, f"{name}_r", first, last, along, why=why.RATE_OF_LENGTH)
    held = draft.constant(constants(index)[-1], damping, "N·s/m")
    return draft.draw(damper_force, letter, held, rate, plan.mu, unit="N")
