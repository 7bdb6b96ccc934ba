"""The colours of the page: letters and lines stand out from what they are on, by day and by night."""

import re
from importlib.resources import files

import pytest

CSS = (files("graphic_tmm.page") / "web" / "theme.css").read_text("utf-8")
THEMES = dict(
    zip(
        ("light", "dark", "dark by the system"),
        re.findall(r"color-scheme: \w+; ([^}]*)}", CSS),
        strict=True,
    )
)
LEAST = 4.5
EDGE = 3.0
"""What WCAG asks of text, and of what bounds a button."""


def colours(theme: str) -> dict[str, tuple[float, ...]]:
    found = re.findall(r"--(\w+): #([0-9a-f]+)", THEMES[theme])
    return {name: _parts(value) for name, value in found}


def _parts(value: str) -> tuple[float, ...]:
    full = value if len(value) == 6 else "".join(2 * one for one in value)
    return tuple(int(full[k : k + 2], 16) / 255 for k in (0, 2, 4))


def luminance(colour: tuple[float, ...]) -> float:
    r, g, b = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour)
    return 0.2126 * r + 0.7152 * g + 0.0722 * b


def contrast(one: tuple[float, ...], other: tuple[float, ...]) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("theme", THEMES)
def test_what_is_read_stands_out(theme):
    found = colours(theme)
    pale = {
        (ink, on): round(contrast(found[ink], found[on]), 2)
        for ink in ("ink", "text", "new", "tool", "lit", "rubbed")
        for on in ("paper", "ground")
        if contrast(found[ink], found[on]) < LEAST
    }
    assert pale == {}
    assert min(contrast(found["edge"], found[on]) for on in ("paper", "ground")) >= EDGE


def test_dark_is_dark_whoever_asks_for_it():
    assert colours("dark") == colours("dark by the system")
