"""What columns were called in earlier versions: such names are read for ever, and never printed again.

A name given up gets a row of `FORMER`; a new name that something else had before must not be given.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from typing import NamedTuple

from graphic_tmm.language.names import plain
from graphic_tmm.readers.columns import Column


class Former(NamedTuple):
    """A kind of name that is printed no more.

    ``until``: the first version that has another; ``then``: a pattern of the name; ``now``: what the segment
    stands for, by the parts of the pattern: that letter has stayed.
    """

    until: str
    plan: str
    then: str
    now: str


_POINT = r"([^\W\d_]\d*′*)"
FORMER = (
    # nab, tba3, kaa3, raa3: an₂, n₃a₃, ak₂, k₂a₃ on the plan
    Former("0.13.0", "accelerations", rf"([ntkr]){_POINT}{_POINT}", "a_{2}{1}^{0}"),
    # na, ta, of a crank that speeds up: πn₁, n₁a
    Former("0.13.0", "accelerations", rf"([nt]){_POINT}", "a_{1}^{0}"),
    # noa, toa, of the same, with its pivot
    Former("0.4.0", "accelerations", rf"([nt]){_POINT}{_POINT}", "a_{2}^{0}"),
    # sB, a way that has no sign: |s_B|, apart from the way that a diagram lays off
    Former("0.13.0", "positions", rf"s{_POINT}", "|s_{0}|"),
)
"""Every name given up, the newest first; what several rows fit is what the first says, if it is there."""
_LEFT_OUT = str.maketrans("", "", "_{} ")


def renamed(plan: str, typed: str, known: Mapping[str, Collection[str]]) -> str:
    """Return the segment that a plan had under this name in an earlier version, "" if none or still.

    ``known``: the segments that are there now, with what they stand for (and whatever else they are called).
    """
    bare = typed.translate(_LEFT_OUT)
    for row in () if bare in known else FORMER:
        found = re.fullmatch(row.then, bare) if row.plan == plan else None
        if found is not None:
            now = row.now.format(*found.groups()).casefold()
            for segment, called in known.items():
                if now in map(str.casefold, called):
                    return segment
    return ""


def is_called(column: Column, name: str) -> bool:
    """Whether a column has this name, or had it in an earlier version."""
    return name == column.segment or bool(
        renamed(column.plan, name, {column.segment: (plain(column.quantity),)})
    )
