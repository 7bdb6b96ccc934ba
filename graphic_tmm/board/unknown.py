"""Numbers and truths that are not known yet: what is done to them is noted on a tape.

A complex number is two real ones. Nobody may ask what is not known.
"""

from __future__ import annotations

from typing import Any

from graphic_tmm.board.tape import Part, Ref, Tape


class NotTraced(Exception):
    """An operation looks at numbers that are not known yet, or does what the tape has no pass for."""


class _Unknown:
    """What is not known yet: nobody may ask it anything."""

    __slots__ = ()
    __array_ufunc__ = None
    __hash__ = None  # type: ignore[assignment]

    def _asked(self, *_: object) -> Any:
        raise NotTraced(type(self).__name__)

    __bool__ = __float__ = __int__ = __complex__ = __index__ = _asked
    __iter__ = __len__ = __getitem__ = __array__ = __getattr__ = _asked


class Mask(_Unknown):
    """A truth for every position."""

    __slots__ = ("node", "tape")

    def __init__(self, tape: Tape, node: int) -> None:
        self.tape, self.node = tape, node

    def _with(self, does: str, *others: object) -> Mask:
        if not all(isinstance(other, Mask) for other in others):
            raise NotTraced(does)
        nodes = [other.node for other in others]  # type: ignore[attr-defined]
        return Mask(self.tape, self.tape.note(does, self.node, *nodes))

    def __and__(self, other: object) -> Mask:
        return self._with("logical_and", other)

    def __or__(self, other: object) -> Mask:
        return self._with("logical_or", other)

    def __invert__(self) -> Mask:
        return self._with("logical_not")


class Value(_Unknown):
    """A number for every position: real where the imaginary part is nothing, and the real part is not."""

    __slots__ = ("im", "re", "tape")

    def __init__(self, tape: Tape, re: Part, im: Part = None) -> None:
        self.tape, self.re, self.im = tape, re, im

    @property
    def real(self) -> Value:
        """The real part."""
        return Value(self.tape, 0.0 if self.re is None else self.re)

    @property
    def imag(self) -> Value:
        """The imaginary part."""
        return Value(self.tape, 0.0 if self.im is None else self.im)

    def conj(self) -> Value:
        """Return the conjugate."""
        return Value(self.tape, self.re, self.tape.opposite(self.im))

    def part(self) -> Part:
        """Return the only part of a real number."""
        if self.im is not None or self.re is None:
            raise NotTraced("a complex number")
        return self.re

    def _of(self, other: object) -> Value:
        return valued(self.tape, other)

    def __neg__(self) -> Value:
        return Value(self.tape, self.tape.opposite(self.re), self.tape.opposite(self.im))

    def __pos__(self) -> Value:
        return self

    def __add__(self, other: object) -> Value:
        b, tape = self._of(other), self.tape
        return Value(tape, tape.plus(self.re, b.re), tape.plus(self.im, b.im))

    __radd__ = __add__

    def __sub__(self, other: object) -> Value:
        return self + -self._of(other)

    def __rsub__(self, other: object) -> Value:
        return self._of(other) + -self

    def __mul__(self, other: object) -> Value:
        b, tape = self._of(other), self.tape
        return Value(
            tape,
            tape.minus(tape.times(self.re, b.re), tape.times(self.im, b.im)),
            tape.plus(tape.times(self.re, b.im), tape.times(self.im, b.re)),
        )

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Value:
        b, tape = self._of(other), self.tape
        if b.im is None:
            return Value(tape, tape.over(self.re, b.re), tape.over(self.im, b.re))
        if length := tape.there("length", *b._bare()):
            # what is known by its length is known by its direction too
            near = 1.0 / Value(tape, length)
            return self * (b * near).conj() * near
        # by the larger part, so that no square leaves the range of numbers
        large = Value(tape, tape.call("maximum", *(tape.call("absolute", p) for p in (b.re, b.im))))
        low = b / large
        size = Value(tape, tape.plus(tape.times(b.re, low.re), tape.times(b.im, low.im)))
        return self * low.conj() * (1.0 / size)

    def __rtruediv__(self, other: object) -> Value:
        return self._of(other) / self

    def __pow__(self, other: object) -> Value:
        if isinstance(other, int | float) and other in (2, 3, 4):
            square = self * self
            return square if other == 2 else square * (self if other == 3 else square)
        return Value(self.tape, self.tape.call("power", self.part(), self._of(other).part()))

    def __rpow__(self, other: object) -> Value:
        return self._of(other) ** self

    def __abs__(self) -> Value:
        if self.im is None:
            return Value(self.tape, self.tape.call("absolute", self._bare()[0]))
        return Value(self.tape, self.tape.call("length", *self._bare()))

    def _bare(self) -> list[Part]:
        """Return both parts without signs before them."""
        return [Ref(p.node) if isinstance(p, Ref) else p for p in (self.re, self.im)]

    def _compared(self, does: str, other: object) -> Mask:
        b = self._of(other)
        return Mask(self.tape, self.tape.compare(does, self.part(), b.part()))

    def __lt__(self, other: object) -> Mask:
        return self._compared("less", other)

    def __le__(self, other: object) -> Mask:
        return self._compared("less_equal", other)

    def __gt__(self, other: object) -> Mask:
        return self._compared("greater", other)

    def __ge__(self, other: object) -> Mask:
        return self._compared("greater_equal", other)

    def __eq__(self, other: object) -> Mask:  # type: ignore[override]
        b, tape = self._of(other), self.tape
        found = Mask(tape, tape.compare("equal", self.re, b.re))
        if self.im is None and b.im is None:
            return found
        return found & Mask(tape, tape.compare("equal", self.im, b.im))

    def __ne__(self, other: object) -> Mask:  # type: ignore[override]
        return ~(self == other)


def valued(tape: Tape, value: object) -> Value:
    """Return a known number as one on a tape; what is on it already, as it is."""
    if isinstance(value, Value):
        return value
    if isinstance(value, int | float):
        return Value(tape, float(value))
    if isinstance(value, complex):
        return Value(tape, value.real or None, value.imag or None)
    raise NotTraced(repr(value))
