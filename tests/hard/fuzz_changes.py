"""Changes of a scene file at random: numbers, units, words, lines, sections, bytes."""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

sys.path.insert(
    0, str(Path(__file__).parents[1])
)  # run by themselves, the files here find those of support

from support.gallery import SHEETS

NUMBER = re.compile(r"(?<![\w.\"#])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.])")
AMOUNT = re.compile(r'"[-+]?\d+(?:\.\d+)? ?[^"\n]{0,8}"')
WORD = re.compile(r'"[^"\n]*"')
STRANGE = (
    *("0", "-0.0", "1", "-1", "1e-300", "1e300", "-1e308", "5e-324", "1e-16", "nan", "inf", "-inf"),
    *("1e6", "1e-6", "9007199254740993", "2.5", "true", "false", '""', '" "', '"x"', "[]", "{}"),
    *("[0, 0]", "[[0]]", "1979-05-27", '"0 mm"', '"-1 kg"', '"90 deg"', '"1e400 m"', '"NaN m"'),
)
UNITS = ("mm", "m", "kg", "deg", "rpm", "1/s", "N", "kg*m^2", "rad/s", "Pa", "%", "kgf", "")
SECTIONS = (
    "[frame]",
    "[drive]",
    "[hand]",
    "[[link]]",
    "[[sheet]]",
    "[plans]",
    "[title_block]",
    "[cam]",
)
Change = Callable[[random.Random, str], str]


def at_one(
    source: random.Random, text: str, what: re.Pattern[str], by: Callable[[str], str]
) -> str:
    found = list(what.finditer(text))
    if not found:
        return text
    one = source.choice(found)
    return text[: one.start()] + by(one[0]) + text[one.end() :]


def _nudge(source: random.Random, old: str) -> str:
    factor = source.choice((0.0, -1.0, 0.5, 2.0, 1 + 1e-15, 1 - 1e-9, 1e6, 1e-6, 10.0, 1.1))
    try:
        return repr(float(old) * factor)
    except ValueError:
        return old


def number(source: random.Random, text: str) -> str:
    return at_one(source, text, NUMBER, lambda old: _nudge(source, old))


def amount(source: random.Random, text: str) -> str:
    def by(old: str) -> str:
        value, _, unit = old.strip('"').partition(" ")
        if source.random() < 0.2:
            unit = source.choice(UNITS)
        return f'"{_nudge(source, value)} {unit}"'

    return at_one(source, text, AMOUNT, by)


def strange(source: random.Random, text: str) -> str:
    return at_one(
        source, text, source.choice((NUMBER, AMOUNT, WORD)), lambda _: source.choice(STRANGE)
    )


def swap_words(source: random.Random, text: str) -> str:
    words = WORD.findall(text)
    return at_one(source, text, WORD, lambda _: source.choice(words)) if words else text


def _lines(text: str) -> list[str]:
    return text.split("\n")


def drop_line(source: random.Random, text: str) -> str:
    lines = _lines(text)
    lines.pop(source.randrange(len(lines)))
    return "\n".join(lines)


def double_line(source: random.Random, text: str) -> str:
    lines = _lines(text)
    lines.insert(source.randrange(len(lines)), source.choice(lines))
    return "\n".join(lines)


def move_line(source: random.Random, text: str) -> str:
    lines = _lines(text)
    lines.insert(source.randrange(len(lines)), lines.pop(source.randrange(len(lines))))
    return "\n".join(lines)


def _blocks(text: str) -> list[str]:
    return re.split(r"(?m)^(?=\[)", text)


def drop_block(source: random.Random, text: str) -> str:
    blocks = _blocks(text)
    blocks.pop(source.randrange(len(blocks)))
    return "".join(blocks)


def shuffle_blocks(source: random.Random, text: str) -> str:
    head, *blocks = _blocks(text)
    source.shuffle(blocks)
    return "".join([head, *blocks])


def graft(source: random.Random, text: str) -> str:
    """Put a section of another scene in, or in place of one."""
    other = _blocks(source.choice(list(scenes().values())))
    blocks = _blocks(text)
    at = source.randrange(len(blocks))
    blocks[at : at + source.randrange(2)] = [source.choice(other)]
    return "".join(blocks)


def bytes_of(source: random.Random, text: str) -> str:
    at = source.randrange(len(text) + 1)
    return (
        text[:at] + source.choice("\x00\t\"'[]{}=,.#\\é\u202e�е") + text[at + source.randrange(3) :]
    )


def cut_off(source: random.Random, text: str) -> str:
    return text[: source.randrange(len(text) + 1)]


CHANGES: tuple[tuple[Change, int], ...] = (
    *((number, 6), (amount, 8), (strange, 4), (swap_words, 4), (drop_line, 3), (double_line, 1)),
    *(
        (move_line, 1),
        (drop_block, 2),
        (shuffle_blocks, 1),
        (graft, 2),
        (bytes_of, 1),
        (cut_off, 1),
    ),
)


@cache
def scenes() -> dict[str, str]:
    paths = sorted(SHEETS.glob("*/scene.toml"))
    return {path.parent.name: path.read_text(encoding="utf-8") for path in paths}


def changed_scene(source: random.Random, name: str) -> str:
    """Return the text of a scene with one to three changes."""
    text = scenes()[name]
    ways, weights = zip(*CHANGES, strict=True)
    for way in source.choices(ways, weights, k=source.choice((1, 1, 2, 3))):
        text = way(source, text)
    return text
