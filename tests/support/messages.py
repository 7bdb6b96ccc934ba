"""Every text of the package that a catalogue should have, found by reading the source.

A text is the first argument of ``said(…)`` or of ``_(…)``, the plural behind it, the keyword ``context``; and
what the operations of the board say: their sentences, why they fail, gaps and sides; the helps of commands;
what the sections of a scene say of themselves and of their keys.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

import graphic_tmm

PACKAGE = Path(graphic_tmm.__file__).parent
MARKS = ("said", "_")
WORD = re.compile(r"[^\W\d_]")


class Message(NamedTuple):
    """A text in English, its plural, its context, and the file where it stands."""

    context: str
    text: str
    plural: str
    file: str

    @property
    def key(self) -> tuple[str, str]:
        return self.context, self.text


def sources() -> tuple[Path, ...]:
    """Return the files of the package, in order."""
    return tuple(sorted(PACKAGE.rglob("*.py")))


def _constant(node: ast.expr) -> str | None:
    plain = isinstance(node, ast.Constant) and isinstance(node.value, str)
    return node.value if plain else None  # type: ignore[attr-defined, no-any-return]


@cache
def nodes(file: Path) -> tuple[ast.AST, ...]:
    """Return all nodes of a file of the package, read once."""
    return tuple(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))


def calls(file: Path) -> Iterator[ast.Call]:
    """Yield the calls by which a file marks its texts."""
    for node in nodes(file):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in MARKS:
            yield node


def _of_file(file: Path) -> Iterator[Message]:
    short = str(file.relative_to(PACKAGE.parent))
    for call in sorted(calls(file), key=lambda one: (one.lineno, one.col_offset)):
        texts = [_constant(one) for one in call.args]
        contexts = [_constant(k.value) for k in call.keywords if k.arg == "context"]
        if texts and texts[0] is not None:
            plural = texts[1] if len(texts) > 1 else ""
            yield Message((contexts or [""])[0] or "", texts[0], plural or "", short)


def _helps(file: Path) -> Iterator[Message]:
    """Yield what the help of commands says: the docstring of each."""
    for node in nodes(file):
        if isinstance(node, ast.FunctionDef) and any(map(_commands, node.decorator_list)):
            text = (ast.get_docstring(node) or "").partition("\f")[0]
            yield Message("", text, "", str(file.relative_to(PACKAGE.parent)))


def _commands(decorator: ast.expr) -> bool:
    called = decorator.func if isinstance(decorator, ast.Call) else None
    return isinstance(called, ast.Attribute) and called.attr in ("command", "group")


def _of_operations() -> Iterator[Message]:
    from graphic_tmm.board.grammar import OPERATIONS

    for file in sources():
        text = file.read_text(encoding="utf-8")
        if "operation(" in text or "formula(" in text:
            import_module(".".join(file.relative_to(PACKAGE.parent).with_suffix("").parts))
    for op in OPERATIONS.values():
        file = str(Path(*op.run.__module__.split("."))) + ".py"
        sentence = () if op.formula else (op.sentence,)
        for text in (*sentence, op.fails, *(gap.says for gap in op.gaps), *op.sides):
            yield Message("", text, "", file)


def _of_sections() -> Iterator[Message]:
    from graphic_tmm.scene.keys import sentences
    from graphic_tmm.scene.new import schema
    from graphic_tmm.scene.sections import declared

    for text in (*sentences(), *_described(schema()), *(one.says for one in declared().values())):
        yield Message("", text, "", "graphic_tmm/scene/keys.py")


def _described(part: Any) -> Iterator[str]:
    """Yield what a schema says to people."""
    inner = part.values() if isinstance(part, dict) else part if isinstance(part, list) else ()
    if isinstance(part, dict) and isinstance(part.get("description"), str):
        yield part["description"]
    for one in inner:
        yield from _described(one)


def _of_beginnings() -> Iterator[Message]:
    """Yield what the authors of the scenes that mechanisms are begun from say beside them."""
    from graphic_tmm.commands.new import BEGINNINGS
    from graphic_tmm.scene.new import REMARK, mechanism_of
    from graphic_tmm.scene.packaged import scene_path

    for one in BEGINNINGS:
        text = (scene_path(one.scene) / "scene.toml").read_text(encoding="utf-8")
        for remark in REMARK.findall(mechanism_of(text)):
            yield Message("", remark, "", "graphic_tmm/beginnings.py")


@cache
def messages() -> tuple[Message, ...]:
    """Return every text once that has a word in it, in the order of the files."""
    found: dict[tuple[str, str], Message] = {}
    own = [one for file in sources() for one in (*_of_file(file), *_helps(file))]
    for one in sorted(
        [*own, *_of_operations(), *_of_sections(), *_of_beginnings()], key=lambda one: one.file
    ):
        known = found.setdefault(one.key, one)
        if one.plural and not known.plural:
            found[one.key] = one
    return tuple(one for one in found.values() if WORD.search(placed(one.text)) or one.context)


def placed(text: str) -> str:
    """Return a text without its placeholders; braces of an index are none."""
    return PLACE.sub("", text)


PLACE = re.compile(r"(?<![_^{])\{(\w*)(?:[!:][^{}]*)?\}(?!\})")


def places(text: str) -> tuple[str, ...]:
    """Return the names of the placeholders of a text, sorted."""
    return tuple(sorted(set(PLACE.findall(text))))
