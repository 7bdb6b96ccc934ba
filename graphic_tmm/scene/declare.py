"""How a section of a scene is declared: a frozen record whose fields tell what may be written for them.

A field is a key of the section (`key`), or is made of several (`combined_key`), or neither: then only a
program sets it. From the one declaration come the reading with its faults, the schema, the reference of
keys, and the record that plans use.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from graphic_tmm.scene.bare import taken

if TYPE_CHECKING:
    from graphic_tmm.board.bounds import Bound
    from graphic_tmm.mechanism.records import Mechanism, Row

Path = tuple[str | int, ...]
Names = Mapping[str, float]
Renaming = Mapping[str | int, str | int]
Schema = dict[str, Any]
Said = SimpleNamespace
"""What a section says, by key; a default where it says nothing."""


class Flaw(NamedTuple):
    """Something wrong at a path of the parsed document; no ``fault``: only to be told."""

    path: Path
    message: str
    fault: bool = True


class _Faulty:
    """What stands for a value that could not be read."""


FAULTY = _Faulty()


class Sort(Protocol):
    """What may stand for a key: one value, or a table or list of others."""

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return what a value of the file means, or FAULTY with what is wrong at the end of ``found``."""

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return what an editor is told; records that it refers to are put into ``tables``."""


@dataclass(frozen=True)
class Kind:
    """One value: ``read`` takes it with the named lengths, or raises ValueError with the remedy.

    ``told``: what an editor is told of it. ``bound``: between which numbers it lies, in the unit of the record;
    a plan that refuses on its own asks here. ``unit``: that of a number without one, for people; ``each``: of
    the numbers in a list, where a list is called otherwise. ``renamed``: where letters, guides or links are
    named: a value, and what some of these are called instead -> the value then.
    """

    read: Callable[[object, Names], Any]
    told: Schema | Callable[[], Schema]
    bound: Bound | None = None
    unit: str = ""
    each: str = ""
    renamed: Callable[[Any, Renaming], Any] | None = None

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return what a value means, or FAULTY."""
        try:
            meant = self.read(value, names)
        except ValueError as error:
            found.append(Flaw(at, error.args[0]))
            return FAULTY
        found.extend(Flaw(at, line, fault=False) for line in taken(value, self.each or self.unit))
        return meant

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return what an editor is told."""
        return dict(self.told() if callable(self.told) else self.told)


@dataclass(frozen=True)
class Key:
    """A key of a section: what may stand there, a sentence, an example, its default.

    ``default``: the value, as it is read; MISSING where the key has to be written. ``fixes``: "size" where it
    fixes how large something is drawn. ``symbol``: the letter of what it gives, if its name is none.
    """

    kind: Sort
    says: str
    example: Any
    default: Any
    fixes: str = ""
    symbol: str = ""

    def left_out(self) -> Any:
        """Return the default, a new one where it could be changed."""
        return dict(self.default) if isinstance(self.default, dict) else self.default


def key(
    kind: Sort,
    says: str,
    example: Any = None,
    default: Any = MISSING,
    *,
    written: str = "",
    fixes: str = "",
    symbol: str = "",
) -> Any:
    """Return a field that is a key of the file (``written`` differently there); as `Key`."""
    declared = Key(kind, says, example, default, fixes, symbol)
    about = {"keys": {written: declared}, "make": None}
    if isinstance(default, dict):
        return field(default_factory=declared.left_out, metadata=about)
    return field(default=default, metadata=about)


def combined_key(make: Callable[[Said], Any], default: Any = MISSING, **keys: Any) -> Any:
    """Return a field that is made of several keys; ``make``: all that the section says -> its value.

    ``default``: of the record, where a program leaves it out.
    """
    told = {name: one.metadata["keys"][""] for name, one in keys.items()}
    return field(default=default, metadata={"keys": told, "make": make})


@cache
def keys_of(record: type) -> Mapping[str, Key]:
    """Return the keys that a record declares, in order."""
    found: dict[str, Key] = {}
    for one in fields(record):
        for name, declared in one.metadata.get("keys", {}).items():
            found[name or one.name] = declared
    return found


def build(record: type, said: Said, **others: object) -> Any:
    """Return the record of what a section says; ``others``: fields that no key of it sets."""
    values = dict(others)
    for one in fields(record):
        if one.metadata and one.name not in others:
            make, keys = one.metadata["make"], list(one.metadata["keys"])
            values[one.name] = make(said) if make else getattr(said, keys[0] or one.name)
    return record(**values)


def bound_of(record: type, name: str) -> Bound:
    """Return between which bounds the number of a key lies; a key that tells none is a fault of the program."""
    kind = keys_of(record)[name].kind
    assert isinstance(kind, Kind)
    assert kind.bound is not None, name
    return kind.bound


class OtherSections(Protocol):
    """What else a scene asks for, as far as it is known when a task is put together."""

    @property
    def mechanism(self) -> Mechanism | None:
        """The mechanism, if there is one."""

    @property
    def row(self) -> Row:
        """Its row of positions."""

    def __getitem__(self, section: str) -> Any:
        """Return the record of a section, a tuple where there may be several; None if it is not there."""


Check = Callable[[Any, Any], Iterator[Flaw]]


@dataclass(frozen=True)
class Section:
    """A section that scenes may have.

    ``record``: its declaration. ``says``: what it is, in the scene.
    ``several``: it is a list of tables. ``together``: it is a table or a list of them, whose records make
    the one that it returns. ``always``: it is read even where it is not written: all its keys have
    defaults. ``alone``: it needs no mechanism. ``gives``: it asks for nothing itself, but for others.
    ``begin``: the keys that it begins with, for a remedy. ``check``: what it said (a list of paths and these,
    if there may be several) -> every contradiction. ``refuse``: where the function stands (module:function)
    that raises TaskError of what the plan cannot take, its record -> nothing. ``joined``: fields of the record
    that come from other sections. ``idle``: what of it comes to nothing, a line each; ``defaults``: those of it
    that matter. ``weighs``: it needs the mass centres of links. ``metric``: its sizes are told in mm,
    whatever the units. ``shows``: its record -> other sections that are shown where it is. ``further``: the
    record of those behind the first, where it may be a list of tables.
    """

    name: str
    record: type
    says: str = ""
    several: bool = False
    together: Callable[[tuple[Any, ...]], Any] | None = None
    always: bool = False
    alone: bool = False
    gives: bool = False
    begin: str = ""
    check: Check = lambda said, parts: iter(())
    refuse: str = ""
    joined: Callable[[OtherSections], Mapping[str, object]] = lambda others: {}
    idle: Callable[[Any, Any], Iterator[str]] = lambda said, parts: iter(())
    defaults: Callable[[Any, Any], Iterator[str]] = lambda said, parts: iter(())
    weighs: bool = False
    metric: bool = False
    shows: Callable[[Any], tuple[str, ...]] = lambda record: ()
    further: type | None = None
