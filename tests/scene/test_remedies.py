"""Every remedy that a refusal prints is applied to the scene that provoked it, and helps."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import product
from pathlib import Path

import pytest
from support.boards import in_usual_size
from support.declared_keys import ALL
from support.driven_scenes import NARROW
from support.refusals import SCENE
from support.scenes import slider_crank
from support.wrong_scenes import CASES

from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.scene.declare import Flaw, Key
from graphic_tmm.scene.read import judged
from graphic_tmm.studio import make

FILE = Path("scene.toml")
WRITTEN = re.compile(
    r"(?:write|for example|did you mean|one of|,| or|such as|quotes:|point:|called|it|is) "
    r"(\[\[?[a-z_]+\]?\]|[\w\"]+ = (?:\"[^\"]*\"|\{[^}]*\}|\[[^\]]*\]|[^\s;,]+)|\"[^\"]+\"|true|false|\d[\d.]*)"
)
"""What a message says to write: a section, a key with its value, a value in quotes, a bare one."""
PLACES = (
    r"[^\W\d]\w*(?= =| \{|\])",
    r"(?<=[\[,( ])(\"[^\"]*\"|[\w*.]+)(?=[\],])",
    r"(\"[^\"]*\"|[\w*.]+)(?=\]|$)",
    r"(?<=\[)[^\]]*(?=\])",
    r"(?<=at = )\"\w+\"",
    r"(?<=point = )\"\w+\"",
)
"""Of what was wrong: a key, an item of a list, the last value, a list, the values of a table."""
SHAPES = ("key = value", "O = [0, 0]", 'y = { through = [0, 0], angle = "0 deg" }')
"""How lines look, where a message tells what a section holds: no remedy for what was wrong."""
MORE = [
    ('speed = "120 rpm"', "speed = 120 rpm # of the crank"),
    ('turns = "counterclockwise"', 'turns = "counterclockwise'),
    ("positions = 12", "positions = 12,0"),
    ('zero = "0 deg"', "zero = –10"),
    ('zero = "0 deg"', "zero = –10 deg"),
    ('name = "Rocker"', 'name = "Rocker'),
    ("[lengths]", "[длины]"),
    ("A = [0, 0]", "А = [0, 0]"),
    ('name = "Rocker"', "print_check = да"),
    ('name = "Rocker"', 'print_check = "нет"'),
    ('name = "Rocker"', "print_check = False"),
    ('speed = "120 rpm"', "speed = 0"),
    ('mass = "2 kg"', 'mass = "2 N*m"'),
    ('ruler = "0.1 mm"', 'ruler = "0.1 s"'),
]


def _faults(text: str) -> dict[str, str]:
    try:
        judged(text.encode(), FILE)
    except SceneError as error:
        return {fault.message: fault.key for fault in error.faults}
    return {}


def _candidates(wrong: str, remedy: str) -> Iterator[str]:
    """Yield how a person may put a remedy into the words that were wrong."""
    key, _, value = remedy.partition(" = ")
    bare = (value or remedy).strip('"')
    yield from (
        remedy,
        bare,
        f'"{bare}"',
        f"[[{bare}]]",
        f"[{bare}]",
        f"{wrong}\n{remedy}",
        f"{remedy}\n{wrong}",
    )
    unit = r"(?<=\d )[^\"]+(?=\")"
    yield re.sub(unit, bare, wrong, count=1)
    yield re.sub(r"^(\"[^\"]*\"|[\w.]+)", lambda _: value, wrong, count=1)
    for told in (remedy, bare, f'"{bare}"', f"[{remedy}]", key):
        put = told.replace("\\", "\\\\")
        yield re.sub(r"= .*", f"= {put}", wrong, count=1)
        for place in PLACES:
            yield re.sub(place, put, wrong, count=1)


def _helps(old: str, wrong: str, remedy: str, message: str) -> str | None:
    """Return the text in which a remedy has taken a fault away; None if there is none."""
    where = _faults(SCENE.replace(old, wrong, 1))[message]
    for text in _candidates(wrong, remedy):
        tried = SCENE.replace(old, text, 1)
        if text == wrong:
            continue
        left = _faults(tried)
        syntax = any("this is not TOML" in one or "twice" in one for one in left)
        another = any("nothing says what it is; write a section" in one for one in left)
        if message not in left and (another or where not in left.values()) and not syntax:
            return tried
    return None


WRONG = (
    *(True, 0, -5, 2.5, -1e9, 1e9, "", "abc", "left", "5", "5 foo", "3 kg", "3 N*m", "3 m"),
    *([], [1, "x"], [[1, 2]], {}, {"a": 1}),
)
"""What may stand where something else is wanted."""
VALUE = re.compile(
    r"(?:write|for example|or|one of|,)(?: (?:key|a) =)? (\"[^\"]+\"|\[[^;]*\]|true|false|\{[^;]*\}|-?\d[\d.]*)"
)


def _messages(one: Key, value: object) -> set[str]:
    found: list[Flaw] = []
    one.kind.understood(value, ("key",), {}, found)
    return {told.message for told in found if told.fault and "is missing" not in told.message}


def _put(value: object, wrong: object) -> Iterator[object]:
    """Yield how a value may be put in the place of what was wrong, or of an item of it."""
    yield value
    if isinstance(value, list) and len(value) == 2:
        yield [value, [1, value[1]]]  # a point of a table has to have others
        yield [[0, 0], value, [1, 1]]
    if isinstance(wrong, list):
        yield [value]
        yield [[value]]
        if len(wrong) > 1:
            yield [wrong[0], value]
            yield [value, wrong[1]]
    if isinstance(wrong, dict):
        yield dict.fromkeys(wrong or ("a",), value)
        yield {"forces": value}


def _values(message: str) -> Iterator[tuple[str, object]]:
    for text in VALUE.findall(message):
        with suppress(tomllib.TOMLDecodeError):  # a list with what stands for more
            yield text, tomllib.loads(f"it = {text}")["it"]


def test_every_value_that_a_key_asks_for_is_taken() -> None:
    applied = set()
    for (at, one), wrong in product(ALL, WRONG):
        for message in _messages(one, wrong):
            for text, value in _values(message):
                tried = [_messages(one, candidate) for candidate in _put(value, wrong)]
                assert set() in tried, (at, wrong, text, message, tried)
                applied.add((at, text))
    assert len(applied) > 400


@pytest.fixture(scope="module")
def provoked() -> list[tuple[str, str, str, str]]:
    """What was there, what was put there, a remedy, the message that it is printed in."""
    return list(_provoked())


def _provoked() -> Iterator[tuple[str, str, str, str]]:
    for old, wrong in [*((a, b) for a, b, _ in CASES), *MORE]:
        for message in _faults(SCENE.replace(old, wrong, 1)):
            for remedy in dict.fromkeys(WRITTEN.findall(message)):
                if remedy not in SHAPES:
                    yield old, wrong, remedy, message


def test_many_remedies_are_provoked(provoked: list[tuple[str, str, str, str]]) -> None:
    assert len({(remedy, wrong) for _, wrong, remedy, _ in provoked}) > 150


def test_every_remedy_that_is_printed_helps(provoked: list[tuple[str, str, str, str]]) -> None:
    bad = [
        (wrong, remedy, message)
        for old, wrong, remedy, message in provoked
        if _helps(old, wrong, remedy, message) is None
    ]
    assert not bad, "\n".join(map(str, bad))


ROD = slider_crank(
    "speed = 10\n[effects]\ngravity = true\n[forces]\npositions = [1]\n",
    of_rod='mass = "2 kg"\nrod = "0.35 m"\n',
    of_slider='mass = "3 kg"\ncentre = "B"\n',
)
SLIDER_DRIVES = slider_crank("speed = 1\n").replace(
    "link = 1\nspeed = 1", 'link = 3\nspeed = "0.2 m/s"'
)


@pytest.mark.parametrize(
    ("text", "words", "old", "new"),
    [
        (NARROW, r"extra = \[[^\]]*\]", "speed = 1\n", "speed = 1\n{0}\n"),
        (
            ROD,
            r"(S2), of an even rod halfway from A to B",
            "B = [0.35, 0]",
            "B = [0.35, 0], {0} = [0.175, 0]",
        ),
        (SLIDER_DRIVES, r'side = "left of \w+"', "number = 2\n", "number = 2\n{0}\n"),
    ],
    ids=["range", "rod", "slider"],
)
def test_a_remedy_of_a_mechanism_draws_it(
    text: str, words: str, old: str, new: str, many: Callable[[int, int], int]
) -> None:
    """In its usual size; measured, in the sizes of its sheets."""
    with pytest.raises(TmmError) as refused:
        make(judged(text.encode(), FILE))
    found = re.search(words, str(refused.value))
    assert found, str(refused.value)
    mended = text.replace(old, new.format(found[found.re.groups]) if "{0}" in new else new, 1)
    if "rod =" in text:
        mended = mended.replace("rod =", 'centre = "S2"\nrod =')
    draw = make if many(1, 0) else in_usual_size
    draw(judged(mended.encode(), FILE))
