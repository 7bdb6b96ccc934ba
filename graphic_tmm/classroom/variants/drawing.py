"""Variants drawn from ranges by a seed, no two alike, none of them a bad one; and why others were refused."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from random import Random
from typing import NamedTuple

from graphic_tmm.classroom.variants.good import measure_of, refused
from graphic_tmm.classroom.variants.ranges import Ranges
from graphic_tmm.classroom.variants.variant import Base, Variant
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import Said, joined, said

IN_A_ROW = 200
"""After so many bad variants in a row no more are tried. Where three in two hundred are good, that happens once
in twenty rows; in the packaged ranges a third is good at the least."""
LISTED = 100_000
"""So many variants are put into an order; of more of them numbers are drawn, those that were drawn left out."""
TOLD = 8
"""So many reasons are told, those of the most variants."""
Tell = Callable[[int, int, str], None]
"""done, of how many, what is told of that."""


class DrawnVariants(NamedTuple):
    """Good variants, how many were tried for them, and how many were refused, by reason."""

    variants: tuple[Variant, ...]
    tried: int
    refusals: Mapping[str, int]

    @property
    def told(self) -> Said:
        """A sentence: of 113 tried 30 were good; refused: 41 …"""
        head = said("of {tried} tried {good} were good", tried=self.tried, good=len(self.variants))
        if not self.refusals:
            return head
        by_count = sorted(self.refusals.items(), key=lambda item: (-item[1], item[0]))
        listed: list[str] = [
            said("{count} {reason}", count=count, reason=reason)
            for reason, count in by_count[:TOLD]
        ]
        if rest := sum(count for _, count in by_count[TOLD:]):
            listed.append(said("{count} for other reasons", count=rest))
        return said("{head}; refused: {listed}", head=head, listed=joined(", ", listed))


def drawn(
    of: Base,
    ranges: Ranges,
    count: int,
    seed: int,
    *,
    missing: Callable[[str], str] = lambda text: "",
    tell: Tell = lambda done, of, name: None,
) -> DrawnVariants:
    """Draw variants of a scene, named 01, 02, …; the same on every machine.

    Parameters
    ----------
    of, ranges
        The scene, and what of it varies; what a good variant is.
    count, seed
        How many are wanted; which of many such rows.
    missing
        As for `scene.read.read`.
    tell
        Told how many there are.

    Raises
    ------
    TmmError
        If the scene itself cannot be drawn.
    SheetError
        If the ranges do not hold so many good variants, or `IN_A_ROW` were bad: why they were.
    """
    if count > ranges.all:
        raise SheetError(
            said(
                "the ranges hold {all} variants, {count} are wanted: widen them, or make steps smaller",
                all=ranges.all,
                count=count,
            )
        )
    by = measure_of(of, ranges.good, missing)
    found, reasons, in_a_row, tried = list[Variant](), Counter[str](), 0, 0
    width = max(2, len(str(count)))
    for number in _numbers(ranges.all, seed):
        if len(found) == count or in_a_row == IN_A_ROW:
            break
        one = _variant(ranges, number, f"{len(found) + 1:0{width}d}")
        reason, tried = refused(of, one, by), tried + 1
        if reason:
            reasons[reason] += 1
            in_a_row += 1
        else:
            found.append(one)
            in_a_row = 0
        tell(len(found), count, said("{tried} tried", tried=tried))
    result = DrawnVariants(tuple(found), tried, dict(reasons))
    if len(found) < count:
        says = said(
            "the ranges do not hold {count} good variants: {told}; widen the ranges, or lower the limits in "
            "[good]",
            count=count,
            told=result.told,
        )
        raise SheetError(says)
    return result


def _numbers(count: int, seed: int) -> Iterator[int]:
    """Yield the numbers of variants in an order that a seed sets, each once."""
    random = Random(seed)
    if count <= LISTED:
        numbers = list(range(count))
        random.shuffle(numbers)
        yield from numbers
        return
    seen = set[int]()
    while True:
        number = random.randrange(count)
        if number not in seen:
            seen.add(number)
            yield number


def _variant(ranges: Ranges, number: int, name: str) -> Variant:
    """Return the variant of a number: the last range varies fastest."""
    values = []
    for one in reversed(ranges.ranges):
        number, k = divmod(number, len(one.values))
        values.append(one.at(k))
    return Variant(name, tuple(reversed(values)))
