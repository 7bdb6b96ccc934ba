"""The protocol of a plan as records: what a student does, step by step, with the figures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple, overload

from graphic_tmm.face.html import rendered
from graphic_tmm.language.symbols import spoken
from graphic_tmm.readers.narration import ProtocolLine
from graphic_tmm.readers.protocol import PlanProtocol, text_of


class Step(NamedTuple):
    """A line of a protocol.

    ``number``: of the step in its plan, 0 of a remark or an equation; ``label``: the same as it is printed, of
    several steps told together ``"8–9"``. ``text``: what is done; ``calculation``: with the numbers put in,
    ``""`` if there is none; ``why`` it is done, ``""`` if nobody says. ``letter``: of what it leaves.
    ``value``: the figure that it leaves, in its ``unit`` (mm on the sheet, or SI); None if that is no figure.
    """

    number: int
    label: str
    text: str
    calculation: str = ""
    why: str = ""
    letter: str = ""
    value: float | None = None
    unit: str = ""


class Part(NamedTuple):
    """The protocol of one plan: its ``title``, its ``steps``."""

    title: str
    steps: tuple[Step, ...]


class Steps(Sequence[Step]):
    """The steps of plans, one after the other; printed, they read as ``graphic-tmm steps`` prints them.

    Parameters
    ----------
    parts : sequence of Part
        The protocols, plan by plan; of each its ``title`` and its ``steps``.
    text : str
        What is printed.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> steps = tmm.draw("crank-rocker").steps("accelerations", 2)
    >>> next(one for one in steps if one.letter == "an2").value
    5.80...
    """

    def __init__(self, parts: Sequence[Part], text: str) -> None:
        self.parts, self._text = tuple(parts), text
        self._steps = tuple(step for part in self.parts for step in part.steps)

    @overload
    def __getitem__(self, index: int) -> Step: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Step, ...]: ...

    def __getitem__(self, index: int | slice) -> Step | tuple[Step, ...]:
        """Return a step, or several, by their place among all."""
        return self._steps[index]

    def __iter__(self) -> Iterator[Step]:
        return iter(self._steps)

    def __len__(self) -> int:
        return len(self._steps)

    def __repr__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        """Return the protocol for a notebook."""
        return rendered("steps.html", parts=self.parts)


def steps_of(told: Sequence[PlanProtocol], language: str, *, why: bool) -> Steps:
    """Return protocols as `readers.protocol` words them; ``why``: print the reasons, too."""
    parts = [Part(one.title, tuple(_step(line, language) for line in one.lines)) for one in told]
    return Steps(parts, "\n".join(line for one in told for line in text_of(one, language, why)))


def _step(line: ProtocolLine, language: str) -> Step:
    letter = "" if line.step is None else spoken(line.step.it, language)
    label = line.label if line.number else ""
    told = line.text, line.calculation, line.why
    return Step(line.number, label, *told, letter, line.value, line.unit)
