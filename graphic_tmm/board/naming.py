"""What segments of a plan are called: by the letters at their ends, and how machines write that."""

from __future__ import annotations

from graphic_tmm.board.record import TALLY, Mark

RATES = {"ω": "omega", "ε": "epsilon"}


def between(start: Mark, end: str) -> str:
    """Return the letter of the segment from a point to another: πa, aa3, n3a3, as both stand on the plan.

    The one place where a segment of a plan of vectors gets its name: the end may not be drawn yet.
    """
    return f"{start.letter}{end}"


def segment_name(letter: str) -> str:
    """Return a letter of the log as machines read it: P_{i3} -> Pi3, ω_2 -> omega2."""
    stem, _, rest = letter.partition("_")
    if rest and stem in RATES:
        return RATES[stem] + rest.strip("{}")
    return letter.replace(TALLY, "′").translate({ord(sign): None for sign in "_{}"})
