"""What machines call marks."""

from __future__ import annotations

from graphic_tmm.board.record import TALLY

RATES = {"ω": "omega", "ε": "epsilon"}


def segment_name(letter: str) -> str:
    """Return a letter of the log as machines read it: n_{ab} -> nab, ω_2 -> omega2."""
    stem, _, rest = letter.partition("_")
    if rest and stem in RATES:
        return RATES[stem] + rest.strip("{}")
    return letter.replace(TALLY, "′").translate({ord(sign): None for sign in "_{}"})
