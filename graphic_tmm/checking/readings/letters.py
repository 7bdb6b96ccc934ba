"""A student's own letters: which of the scene's each stands for: ``letters;K=A;E=D``, ``--letters K=A``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.readings.csv_cells import CellRow
from graphic_tmm.checking.records import Taken
from graphic_tmm.errors import Fault
from graphic_tmm.language.said import said

Letters = Mapping[str, str]
_TITLE = ("letters", "letter", "буквы", "буква", "обозначения")
_EQUAL = re.compile(r"([^\W\d_]\d*′*)\s*(?:=|->|→|–|—|-)\s*([^\W\d_]\d*′*)")
_SIGN = re.compile("=|->|→")
NEAR = 4.0
"""So near to a due point another letter may be of it, if no other point is within three times that, mm."""
_POINT = re.compile(r"[^\W\d_]\d*′*")


def is_letters(row: CellRow) -> bool:
    """Whether a row tells letters."""
    first, *others = row.cells or ("",)
    return first.strip().casefold().rstrip(":") in _TITLE and any(map(_SIGN.search, others))


def letters_of(texts: Iterable[str], line: int = 0) -> tuple[dict[str, str], tuple[Fault, ...]]:
    """Return letters by the student's own, and what is wrong with them.

    >>> letters_of(["K=A, E = D"])[0]
    {'K': 'A', 'E': 'D'}
    """
    found: dict[str, str] = {}
    faults = []
    for text in (part for one in texts for part in re.split(r"[,;]", one) if part.strip()):
        pair = _EQUAL.fullmatch(text.strip())
        if pair is None or pair[1] in found:
            says = said(
                '"{text}" is no pair of letters; write your own first, then the scene\'s: K=A',
                text=text.strip()[:20],
            )
            faults.append(Fault("", line, says))
            continue
        found[pair[1]] = pair[2]
    return found, tuple(faults)


def without_letters(
    rows: Sequence[CellRow],
) -> tuple[list[CellRow], dict[str, str], tuple[Fault, ...]]:
    """Return rows without those that tell letters, the letters, and what is wrong with them."""
    kept: list[CellRow] = []
    letters: dict[str, str] = {}
    faults: list[Fault] = []
    for row in rows:
        if not is_letters(row):
            kept.append(row)
            continue
        more, wrong = letters_of(row.cells[1:], row.line)
        letters |= more
        faults += wrong
    return kept, letters, tuple(faults)


def letter_near(taken: Taken, spots: Mapping[Key, complex]) -> str:
    """Return what is said of a point with a letter that its plan has not, where a due one is near; else ""."""
    if not taken.pointed:
        return ""
    plan, letter, position = taken.key
    far = sorted(
        (abs(spot - taken.spot), one)
        for (p, one, at), spot in spots.items()
        if (p, at) == (plan, position)
    )
    if not far or far[0][0] > NEAR or (len(far) > 1 and far[1][0] < 3.0 * NEAR):
        return ""
    return said(
        'plan {plan} has no point "{letter}"; at this place it has {due}: if that is what you call '
        "{letter}, say so by a row letters;{own}={theirs}, or --letters {own}={theirs}",
        plan=plan,
        letter=letter[:20],
        due=far[0][1],
        own=letter[:20].capitalize(),
        theirs=far[0][1].capitalize(),
    )


def in_letters(name: str, letters: Letters) -> str:
    """Return a name with the scene's letters for a student's own; small ones are those of images on plans.

    >>> in_letters("pk", {"K": "A"}), in_letters("V_EK", {"K": "A", "E": "D"}), in_letters("s2", {"S2": "S3"})
    ('pa', 'V_DA', 's3')
    """
    both = dict(letters) | {one.lower(): to.lower() for one, to in letters.items()}
    return _POINT.sub(lambda found: both.get(found[0], found[0]), name)
