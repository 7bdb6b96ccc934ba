"""The characters that are lettered, and a text in upright letters."""

from __future__ import annotations

from graphic_tmm.paper.lettering.letters import (
    Lettering,
    letter,
)

RUSSIAN = "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ"
LATIN = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
GREEK = "αβγδεζηθϑκλμνξπρστφϕχψωΓΔΘΛΞΠΣΦΨΩ"
DIGITS = "0123456789"
MARKS = ".,:;!?()[]{}/\\|-–—_+=*%&@#№$^~'\"«»„“”’<>"
SIGNS = "·×°′″±−≤≥≈≠→←↑↓⊥∥∠√ΣΔ∑∫∞∂²³⁻¹₀₁₂₃₄₅₆₇₈₉⌀"
SPACES = " \u00a0\u202f\u2009"
ALL = RUSSIAN + RUSSIAN.lower() + LATIN + LATIN.lower() + GREEK + DIGITS + MARKS + SIGNS + SPACES


def upright(text: str, size: float = 10.0) -> Lettering:
    """Return a text in upright letters."""
    return letter(text, size=size, inclined=False)
