"""Readings that stand twice in a file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from graphic_tmm.checking.records import Taken
from graphic_tmm.errors import Fault
from graphic_tmm.language.said import said

_KINDS = tuple((name, Taken._fields.index(name)) for name in ("mm", "value", "x"))


def twice(taken: Sequence[Taken], title: Callable[[str], str] = str) -> Iterator[Fault]:
    """Yield a fault for each reading that an earlier row has given already.

    ``title``: what the file calls a column.
    """
    seen: dict[tuple[str, str, str, str], int] = {}
    for one in taken:
        for name, field in _KINDS:
            if one[field] is None:
                continue
            earlier = seen.setdefault((*one[:3], name), one.line)
            if earlier != one.line:
                place = said(' at position "{position}"', position=one.position)
                says = said(
                    '"{segment}" of "{plan}"{place} stands in line {line} already; keep one of the '
                    "two",
                    segment=one.segment,
                    plan=one.plan,
                    place=place if one.position else "",
                    line=earlier,
                )
                yield Fault(title(name), one.line, says)
