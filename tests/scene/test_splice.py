"""Values set in TOML texts that the test wrote piece by piece: it knows what has to come out, to the byte."""

from __future__ import annotations

import random
import tomllib
from typing import Any, NamedTuple

import pytest

from graphic_tmm.scene.document import quoted
from graphic_tmm.scene.splice import Unplaced, literal, set_to

PLAIN = [
    "7",
    "-0.5",
    "1e3",
    "true",
    '"a # b"',
    "'c ] d'",
    '"ж\\n"',
    '"""x\n# no comment "" """',
    "[]",
]
NEW = ['"8 mm"', "12", "false", '["a", 1]', '"# = ] }"', '""']


class Written(NamedTuple):
    """A text in pieces, which of them is whose value, and what its comments are."""

    pieces: list[str]
    values: dict[tuple[str | int, ...], int]
    tables: list[tuple[str | int, ...]]
    comments: list[str]

    @property
    def text(self) -> str:
        return "".join(self.pieces)

    def with_value(self, path: tuple[str | int, ...], value: str) -> str:
        at = self.values[path]
        return "".join([*self.pieces[:at], value, *self.pieces[at + 1 :]])


class Author:
    """Writes odd but good TOML."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.newline = self.chance.choice(["\n", "\r\n"])
        self.made = Written([], {}, [()], [])

    def write(self) -> Written:
        for name in "tu":
            self.row((), name)
        for k in range(4):
            self.gap()
            several = self.chance.random() < 0.4
            for item in range(self.chance.randint(1, 3) if several else 1):
                name = f"s{k}"
                path = (name, item) if several else (name,)
                blank = self.blank()
                head = f"{blank}{name}{blank}"
                self.add(f"[[{head}]]" if several else f"[{head}]")
                self.end()
                self.made.tables.append(path)
                for key in self.chance.sample(["a", "b_1", '"q r"', "д", "e-f"], 4):
                    bare = key.strip('"')
                    self.row(path, bare, f'"{bare}"' if not bare.isascii() else key)
                if self.chance.random() < 0.5:
                    self.dotted(path)
                self.gap()
        if self.chance.random() < 0.5:  # no newline at the end
            self.made.pieces[-1] = self.made.pieces[-1].rstrip("\r\n")
        return self.made

    def row(self, table: tuple[str | int, ...], name: str, key: str = "") -> None:
        self.add(f"{self.blank()}{key or name}{self.blank()}={self.blank()}")
        self.value((*table, name), 0)
        self.end()

    def dotted(self, table: tuple[str | int, ...]) -> None:
        for name in ("one", "two"):
            self.add(f"dots . {name} = ")
            self.value((*table, "dots", name), 2)
            self.end()

    def value(self, path: tuple[str | int, ...], depth: int) -> None:
        shape = self.chance.random()
        if depth < 2 and shape < 0.2:
            self.array(path, depth)
        elif depth < 2 and shape < 0.4:
            self.braces(path, depth)
        else:
            self.made.values[path] = len(self.made.pieces)
            self.add(self.chance.choice(PLAIN[:-3] if depth else PLAIN))

    def array(self, path: tuple[str | int, ...], depth: int) -> None:
        self.add("[")
        lines = self.chance.random() < 0.5
        for k in range(self.chance.randint(1, 3)):
            if lines:
                self.end()
            self.add(self.blank())
            self.value((*path, k), depth + 1)
            self.add(f"{self.blank()},")
        if lines:
            self.end()
        self.add("]")

    def braces(self, path: tuple[str | int, ...], depth: int) -> None:
        self.add("{")
        for k, name in enumerate("xyz"[: self.chance.randint(1, 3)]):
            self.add(f"{',' if k else ''}{self.blank()}{name}{self.blank()}= ")
            self.value((*path, name), 2)
        self.add(f"{self.blank()}}}")

    def add(self, text: str) -> None:
        self.made.pieces.append(text)

    def blank(self) -> str:
        return self.chance.choice(["", " ", "  ", "\t"])

    def gap(self) -> None:
        for _ in range(self.chance.randint(0, 2)):
            self.end()

    def end(self) -> None:
        if self.chance.random() < 0.5:
            comment = f"# [{len(self.made.comments)}] = \"no\" 'key'"
            self.made.comments.append(comment)
            self.add(f"{self.blank()}{comment}")
        self.add(self.newline)


def at(doc: Any, path: tuple[str | int, ...]) -> Any:
    for part in path:
        doc = doc[part]
    return doc


@pytest.mark.turns(12)
@pytest.mark.parametrize("seed", range(40))
def test_a_value_is_changed_and_no_other_byte(seed: int) -> None:
    written = Author(seed).write()
    tomllib.loads(written.text)
    for k, path in enumerate(written.values):
        value = NEW[(k + seed) % len(NEW)]
        made = set_to(written.text, path, value)
        assert made == written.with_value(path, value)
        assert at(tomllib.loads(made), path) == tomllib.loads(f"x = {value}")["x"]


@pytest.mark.turns(12)
@pytest.mark.parametrize("seed", range(40))
def test_a_key_is_added_on_a_line_of_its_own(seed: int) -> None:
    written = Author(seed).write()
    for table in written.tables:
        made = set_to(written.text, (*table, "new"), '"8 mm"')
        assert at(tomllib.loads(made), (*table, "new")) == "8 mm"
        (line,) = set(made.splitlines()) - set(written.text.splitlines())
        newline = "\r\n" if "\r\n" in written.text else "\n"
        ended = written.text if written.text.endswith(newline) else written.text + newline
        assert ended in (made.replace(line + newline, "", 1), made + newline) or (
            made.replace(newline + line, "", 1) == written.text
        )
    made = set_to(written.text, ("other", "new"), "1")
    assert made.startswith(written.text)
    assert tomllib.loads(made)["other"] == {"new": 1}


@pytest.mark.turns(12)
@pytest.mark.parametrize("seed", range(40))
def test_a_key_is_added_in_braces_and_beside_dots(seed: int) -> None:
    written = Author(seed).write()
    inner = {path[:-1] for path in written.values if path[-1] == "x"}
    inner |= {path[:-1] for path in written.values if "dots" in path}
    for table in inner:
        made = set_to(written.text, (*table, "new"), '"8 mm"')
        assert at(tomllib.loads(made), (*table, "new")) == "8 mm"
        assert is_subsequence(written.text, made)


@pytest.mark.turns(12)
@pytest.mark.parametrize("seed", range(40))
def test_a_key_is_taken_out_and_its_comment_stays(seed: int) -> None:
    written = Author(seed).write()
    for path in written.values:
        if isinstance(path[-1], int):
            continue
        made = set_to(written.text, path, None)
        with pytest.raises(KeyError):
            at(tomllib.loads(made), path)
        assert [comment for comment in written.comments if comment not in made] == []
        assert is_subsequence(made, written.text)


def is_subsequence(short: str, long: str) -> bool:
    """Whether a text is another one with something left out."""
    signs = iter(long)
    return all(sign in signs for sign in short)


def test_the_new_line_stands_as_those_above_it() -> None:
    text = "[drive]\nlink      = 1   # the crank\n  # end\n[hand]\n"
    made = set_to(text, ("drive", "turns"), '"clockwise"')
    assert made == (
        '[drive]\nlink      = 1   # the crank\nturns     = "clockwise"\n  # end\n[hand]\n'
    )


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ("a = 1\n", ("a", "b")),
        ("a = [1]\n", ("a", 4)),
        ("a = [1]\n", ("a", "b")),
        ("[[a]]\nb = 1\n", ("a", "b")),
        ("a = {}\n", ("a", "b", "c", "d")),
        ("[a.b]\nc = 1\n", ("a", "b", "c", "d", "e")),
        ("a = 'x'\n", ("a", 0)),
        ("", ("a", 0, "b")),
    ],
)
def test_what_has_no_place_is_refused(text: str, path: tuple[str | int, ...]) -> None:
    with pytest.raises(Unplaced):
        set_to(text, path, "1")


def test_what_was_not_there_cannot_be_taken_out() -> None:
    with pytest.raises(Unplaced):
        set_to("a = 1\n", ("b",), None)


NO_LITERALS = [
    "1\nb = 2",
    "1 # c",
    "1, 2",
    "a",
    '"a"',
    "[1",
    "{ a = 1 }",
    "0x10",
    "1_0",
    "nan",
    "1979-05-27",
    "",
]


@pytest.mark.parametrize("text", [*NO_LITERALS, "9" * 5000])
def test_no_other_thing_comes_in_as_a_literal(text: str) -> None:
    assert literal(text) is None


@pytest.mark.parametrize("text", ["1", "-0.5", "true", "[1, 2]", '["a"]', "[\n1, # one\n]"])
def test_a_literal_is_its_value(text: str) -> None:
    assert literal(text) == tomllib.loads(f"x = {text}")["x"]


def test_every_sign_survives_its_quotes() -> None:
    text = "".join(map(chr, range(0x250))) + "я\U0001f600\"\"\"'''\\u0041"
    assert tomllib.loads(f"x = {quoted(text)}")["x"] == text
