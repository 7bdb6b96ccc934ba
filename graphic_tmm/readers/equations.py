r"""The vector equations of a plan, read off the log: how the lines of each group met, what is known of them.

A group's point is where two lines met. Each line begins at an image that was known, or at the end of segments
of calculated length laid off from one. So each line is a side of the equation: a vector known in length and
direction (two lines under it) for the image and every segment, and one known in direction (one line) along
the line itself. A side that begins at the pole has no vector but that of the line.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, parallel
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Length
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said

QUANTITIES = {"p": "v", "π": "a"}
"""What a segment stands for whose name begins with the letter of a pole."""
VECTORS = {roles.VELOCITY: "v", roles.ACCELERATION: "a"}
"""The vectors of a plan by the role of its pole."""
_INDEX = re.compile(r"([_^])(\w+)")
_GROUP, _HEADING = (
    re.compile(r"(?P<number>I[IV]+)\((?P<name>.+)\)"),
    said("group {name} of class {number}"),
)
"""How the log heads the steps of a group, and what people read: II before a vector would be a parallel."""
_WHEEL, _ROLLS = re.compile(r"p4\((?P<name>.+)\)"), said("wheel {name} with its higher pair")
"""The same of a wheel that rolls on another."""
_BELTED = re.compile(r"p4\((?P<name>.+)\) by a flexible link")
_DRIVEN = said("wheel {name} with its flexible link")
"""The same of a wheel that a belt or a chain turns."""


class Term(NamedTuple):
    """A vector of an equation: its letter as mark-up, known wholly or in direction, and that direction.

    ``marks``: where its segment begins and ends on the plan; ``line``: the line that it was drawn along, if it
    was.
    """

    symbol: str
    known: bool
    direction: str = ""
    marks: tuple[Mark, ...] = ()
    line: Mark | None = None

    @property
    def barred(self) -> str:
        """The letter of the vector, without lines under it."""
        return _bar(self.symbol)

    def __str__(self) -> str:
        under = "uu" if self.known else "u"
        return f"\\{under}{{{self.barred}}}"


class Equation(NamedTuple):
    """The equation of a group: its heading in the log, the unknown vector, the sides that it equals.

    ``marks``: the ends of the unknown vector on the plan: the pole and the point constructed.
    """

    group: str
    sought: Term | str
    sides: tuple[tuple[Term, ...], ...]
    marks: tuple[Mark, ...] = ()

    @property
    def markup(self) -> str:
        """The equation as lettered on a sheet."""
        left = self.sought if isinstance(self.sought, Term) else _bar(self.sought)
        return " = ".join([str(left), *(" + ".join(map(str, side)) for side in self.sides)])

    @property
    def text(self) -> str:
        """The equation in plain text, as the protocol prints it: v_B = v_A + v_BA."""
        sides = [self.sought if isinstance(self.sought, str) else self.sought.symbol]
        sides += [" + ".join(term.symbol for term in side) for side in self.sides]
        return " = ".join(sides).replace("{", "").replace("}", "")

    @property
    def directions(self) -> str:
        """The directions that are known, as lettered on a sheet: v_{BA} ⊥ AB."""
        found = [self.sought] if isinstance(self.sought, Term) else []
        found += [term for side in self.sides for term in side if term.direction]
        return ", ".join(
            f"{term.symbol}{': ' if '→' in term.direction else ' '}{term.direction}"
            for term in found
        )


def by_group(found: Iterable[Equation]) -> dict[str, list[Equation]]:
    """Return the equations by the headings of their groups: a plate on three legs has two."""
    solved: dict[str, list[Equation]] = {}
    for one in found:
        solved.setdefault(one.group, []).append(one)
    return solved


def heading(note: str, language: str) -> str:
    """Return a remark of the log that heads a group in words; any other remark as it is.

    >>> heading("II(2-3)", "en"), heading("v_A = ω_1·l_{OA}", "en")
    ('group 2-3 of class II', 'v_A = ω_1·l_{OA}')
    """
    for pattern, words in ((_GROUP, _HEADING), (_WHEEL, _ROLLS), (_BELTED, _DRIVEN)):
        if found := pattern.fullmatch(note):
            return speaking(language)(words, **found.groupdict())
    return note


def _bar(symbol: str) -> str:
    r"""Return a vector's letter with its bar: a_{BA}^{n} -> \bar{a}_{BA}^{n}."""
    return f"\\bar{{{symbol[0]}}}{symbol[1:]}"


def components(construction: Construction) -> Mapping[Mark, str]:
    """Return the letters of the components of accelerations, by their segments: n3a3 -> a_{A3B}^{t}."""
    return {one.marks[0]: one.name for one in construction.figures if one.kind == roles.COMPONENT}


def quantity(segment: Mark, of: Mapping[Mark, str], relative: str = "v") -> str:
    """Return the quantity that a segment stands for: pb -> v_{B}, ab -> v_{BA}; a component has its letter.

    ``relative``: what a segment between two images stands for.
    """
    if segment in of:
        return of[segment]
    ends = ends_of(segment.name)
    if ends[0] in QUANTITIES:
        return f"{QUANTITIES[ends[0]]}_{{{''.join(ends[1:]).upper()}}}"
    return f"{relative}_{{{''.join(reversed(ends)).upper()}}}"


def ends_of(letter: str) -> list[str]:
    """Split a segment into the letters of its ends: aa3 -> a, a3."""
    ends: list[str] = []
    for sign in letter:
        if ends and (sign.isdigit() or sign == "′"):
            ends[-1] += sign
        else:
            ends.append(sign)
    return ends


def equations(construction: Construction, plan: str, *, turned: bool = False) -> Iterator[Equation]:
    """Yield the vector equations of a plan of velocities or accelerations, group by group.

    ``turned``: plans of velocities are turned by 90°, so that what is drawn along a line is square to it in
    truth.
    """
    view = construction.view(plan)
    if view is None or view.pole is None or view.pole.role not in VECTORS:
        return
    turned = turned and view.pole.role == roles.VELOCITY
    steps = [step for step in construction.steps if step.it.view == plan]
    read = {s.uses[1:]: s.it for s in steps if s.op is measure_along}
    of = components(construction)
    group, fresh = "", dict[Mark, Step]()
    for step in steps:
        if step.note:
            group, fresh = step.note, {}
        fresh[step.it] = step
        if step.op is meet:
            lines = [fresh[mark] for mark in reversed(step.uses)]
            yield _equation(group, step.it, view.pole, lines, fresh, (read, of), turned)


def _equation(
    group: str,
    point: Mark,
    pole: Mark,
    lines: list[Step],
    fresh: dict[Mark, Step],
    told: tuple[Mapping[tuple[Mark, ...], Mark], Mapping[Mark, str]],
    turned: bool,
) -> Equation:
    """Return the equation of the point where two lines met.

    ``told``: the lengths read to points along lines, by both; the letters of components, by their lengths.
    """
    read, of = told
    root = VECTORS[pole.role]
    name = f"{root}_{{{point.name.upper()}}}"
    sought: Term | str = name
    sides = []
    for line in lines:
        start = line.uses[0]
        known = list[Term]()
        while start in fresh and fresh[start].op is lay_off:
            drawn, length = fresh[start].uses
            end, start = start, fresh[drawn].uses[0]
            way = _direction(fresh[drawn], turned)
            known.insert(0, Term(quantity(length, of), True, way, (start, end), drawn))
        if start != pole:
            known.insert(0, Term(f"{root}_{{{start.name.upper()}}}", True, marks=(pole, start)))
        direction = _direction(line, turned)
        if known:
            symbol = _across(known[-1], line) or _relative(root, point, start, line)
            if (point, line.it) in read:
                symbol = quantity(read[point, line.it], of)
            ends = line.uses[0], point
            sides.append((*known, Term(symbol, False, direction, ends, line.it)))
        else:
            if isinstance(sought, Term):  # both legs of a plate hold on to the frame
                direction = f"{sought.direction}, {direction}"
            sought = Term(name, False, direction, (pole, point), line.it)
    return Equation(group, sought, tuple(sides), (pole, point))


def _across(known: Term, line: Step) -> str:
    """Return the letter of the rest of a vector of which the part along the same line is known; "" else."""
    part = "^{{{}}}".format(line.uses[1].name.strip("()"))
    return known.symbol.replace(part, "^{r}") if known.symbol.endswith(part) else ""


def _relative(root: str, point: Mark, start: Mark, line: Step) -> str:
    """Return the letter of what nobody reads: of Assur's special point about the pivot of a leg."""
    ends = ends_of(line.uses[1].name.strip("()"))
    about = ends[0] if len(ends) == 2 else "" if start.role in VECTORS else start.name.upper()
    whole = f"{root}_{{{point.name.upper()}{about}}}"
    return f"{whole}^{{t}}" if root == "a" else whole


def _direction(line: Step, turned: bool) -> str:
    """Return the direction of a vector by the line drawn for it: ⊥ AB, ∥ y–y, or B → A along a link."""
    of = line.uses[1].name.rstrip("′").strip("()")
    ends = ends_of(of)
    along = (line.op is parallel) != turned
    guide = re.sub(r"^([A-Za-z])(\d+)$", r"\1_{\2}", of)
    # square to a direction, the sense of a turned plan's line is that of its turn
    if along and not turned and line.choice["sense"] < 0 and len(ends) == 2:
        return f"{_indexed(ends[1])} → {_indexed(ends[0])}"
    return f"{'∥' if along else '⊥'} {_indexed(of) if len(ends) > 1 else f'{guide}–{guide}'}"


def _indexed(letters: str) -> str:
    """Return letters with their figures as indices: W3F -> W_{3}F."""
    return letters if "_" in letters else re.sub(r"([^\W\d])(\d+)", r"\1_{\2}", letters)


def polygon(construction: Construction, plan: str) -> tuple[Term, ...]:
    """Return the sides of a polygon of forces, whose sum is nothing, in their order; none of another plan.

    What was laid off is known wholly. Where two lines met, the sides that close the polygon are known in
    direction: first the one that goes on from the last known side. Else one side closes it, as it was measured.
    """
    view = construction.view(plan)
    if view is None or view.pole is None or view.role != roles.FORCE_POLYGON:
        return ()
    steps = [step for step in construction.steps if step.it.view == plan]
    by_mark = {step.it: step for step in steps}
    found, end = list[Term](), view.pole
    for step in steps:
        if step.op is lay_off:
            line = step.uses[0]
            start = by_mark[line].uses[0]
            found.append(Term(_force(line), True, marks=(start, step.it), line=line))
            end = step.it
        elif step.op is meet:
            lines = sorted(step.uses, key=lambda line: by_mark[line].uses[0] != end)
            for line in lines:
                found.append(
                    Term(_force(line), False, marks=(by_mark[line].uses[0], step.it), line=line)
                )
            return tuple(found)
    closing = next(
        (s for s in steps if s.it.kind is Length and set(s.uses[:2]) == {end, view.pole}), None
    )
    if closing is not None:
        letter = closing.it.name.removeprefix("y_{").removesuffix("}")
        found.append(
            Term(f"{letter[0]}_{{{letter[1:]}}}", False, marks=(end, view.pole, closing.it))
        )
    return tuple(found)


def called(terms: tuple[Term, ...], equations: Iterable[str]) -> tuple[Term, ...]:
    """Return the sides of a polygon, named as in the equation of its group if it has one.

    A line is named by the force along it; where that is between stone and guide the equation names another.
    """
    for text in equations:
        letters = [_INDEX.sub(r"\1{\2}", one) for one in text.partition(" = ")[0].split(" + ")]
        if len(letters) == len(terms) > 0:
            return tuple(
                one._replace(symbol=letter) for one, letter in zip(terms, letters, strict=True)
            )
    return terms


def _force(line: Mark) -> str:
    return line.name.strip("()")
