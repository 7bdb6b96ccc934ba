"""Names as students and spreadsheets spell them, by tables of this file alone."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

LIKE = dict(zip("aceopxyBEKMHOPCTXAi", "асеорхуВЕКМНОРСТХАі", strict=True))
SMALL = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
GREEK = {
    "omega": ("ω", "Ω".lower(), "w", "om", "Omega", "omega_", "ω_", "омега", "W"),
    "epsilon": ("ε", "ϵ", "eps", "e", "Epsilon", "ε_", "эпсилон"),
    "π": ("pi", "Pi", "π ", "пи", "ϖ", "п", "𝜋"),
    "Δ": ("∆", "delta", "d", "Delta"),
    "′": ("'", "’", "`"),
}
"""What is written for a Greek letter, or for its name where the package spells it out."""


def greek(source: random.Random, name: str) -> str:
    for letter, ways in GREEK.items():
        if name.startswith(letter) or (letter in "πΔ′" and letter in name):
            return name.replace(letter, source.choice(ways), 1)
    return name


def indexed(source: random.Random, name: str) -> str:
    way = source.choice(("_", " ", "{}", "small"))
    if way == "small":
        return name.translate(SMALL)
    if way == "{}":
        return re.sub(r"(?<=.)([0-9]+)$", r"_{\1}", name)
    at = source.randrange(1, len(name)) if len(name) > 1 else 0
    return name[:at] + way + name[at:] if at else name


def look_alikes(source: random.Random, name: str) -> str:
    return "".join(LIKE.get(sign, sign) if source.random() < 0.6 else sign for sign in name)


def cased(source: random.Random, name: str) -> str:
    return source.choice((str.upper, str.lower, str.title))(name)


def lost(source: random.Random, name: str) -> str:
    """Save the name, with Greek letters as such, in Windows-1251."""
    name = re.sub("^omega(?=[0-9])", "ω", re.sub("^epsilon(?=[0-9])", "ε", name))
    return name.encode("cp1251", "replace").decode("cp1251")


def opened_wrongly(source: random.Random, name: str) -> str:
    """Save the name in UTF-8 and open it in Windows-1251."""
    return name.encode("utf-8").decode("cp1251", "replace").replace("�", "�")


WAYS: tuple[Callable[[random.Random, str], str], ...] = (
    greek,
    indexed,
    look_alikes,
    cased,
    lost,
    opened_wrongly,
)


def misspelt(source: random.Random, name: str) -> tuple[str, str]:
    """Return a name spelt otherwise, and by which way."""
    way = source.choice(WAYS)
    return way(source, name), way.__name__
