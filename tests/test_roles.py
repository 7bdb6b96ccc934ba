"""A letter is for readers: no code tells marks apart by what they are called."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from support.messages import nodes, sources

import graphic_tmm

PACKAGE = Path(graphic_tmm.__file__).parent
ASKING = {"startswith", "endswith", "partition", "rpartition", "split", "find", "index", "count"}
ASKING |= {"removeprefix", "removesuffix", "isdigit", "isupper", "islower", "isalpha", "__eq__"}
KEYED = {"get", "setdefault", "pop"}
MARKS = {"mark", "it", "point", "pole", "image", "start", "end", "length", "line", "curve", "scale"}
"""What marks are called where their ``name`` is asked for; a ``letter`` is always one of a mark."""

ALLOWED = {
    # a point of a scene is known by its letter there: this one is not the letter of a mark
    "chapters/engine/plan.py: closing.letter == order.point",
    "chapters/kinematics/motion.py: known[leg.letter]",
    # one quantity that is given for several plans bears one letter in all of them
    "checking/mutations/mistakes.py: found.setdefault((mark.name, mark.unit), [])",
    # readers are told of which view a mark is where two of a sentence are called alike
    "readers/sentences.py: mark.name in elsewhere",
    # a line that is drawn parallel to its namesake of another view is told so
    "note/gather.py: to.name == step.it.name",
    # machines read the scale factor of a base by what it is called
    "readers/table.py: BASES.get(step.it.name)",
    # a column of a table is known by what it is called
    "page/values.py: s.it.name == column.letter",
    "page/values.py: column.letter != entry.mark.name",
    "page/values.py: ' ' not in column.letter",
    # the side that closes a polygon is called by the force that its length was read for
    "readers/equations.py: closing.it.name.removeprefix('y_{')",
    # the sides of conditions are told once each, by what they are called
    "chapters/trains/table.py: found.setdefault(plain(mark.name), mark)",
    # words that stand for the name of a column
    "readers/result_table.py: words.get(column.letter)",
    "readers/text.py: captions(language).get(column.letter)",
    # people name what they read by the names of the table
    "checking/judging/taken_marks.py: found.setdefault((mark.view, segment_name(mark.letter)), step)",
    # what strokes a text is lettered with
    "paper/write/svg.py: groups.setdefault(letters.letter(label.text, size=label.size).pen, [])",
}


def _is_name(node: ast.expr) -> bool:
    """Whether an expression is the letter of a mark, or its name."""
    if not isinstance(node, ast.Attribute) or node.attr not in ("letter", "name"):
        return False
    owner = node.value
    if isinstance(owner, ast.Subscript):
        owner = owner.value
    called = getattr(owner, "attr", getattr(owner, "id", ""))
    return node.attr == "letter" or called in MARKS | {"uses"}


def _has_name(node: ast.AST) -> bool:
    return any(isinstance(one, ast.expr) and _is_name(one) for one in ast.walk(node))


def _asks(node: ast.AST) -> bool:
    """Whether a node branches on a name, or finds something by it."""
    if isinstance(node, ast.Compare):
        return any(_is_name(side) for side in (node.left, *node.comparators))
    if isinstance(node, ast.Match):
        return _is_name(node.subject)
    if isinstance(node, ast.Subscript):
        return _has_name(node.slice)
    if isinstance(node, ast.DictComp):
        return _has_name(node.key)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr in ASKING and _is_name(node.func.value):
            return True
        return node.func.attr in KEYED and any(_has_name(one) for one in node.args[:1])
    return False


def _found(nodes: Iterable[ast.AST]) -> Iterator[str]:
    return (ast.unparse(node) for node in nodes if _asks(node))


@pytest.mark.parametrize(
    "line",
    [
        'step.it.letter == "P"',
        'step.it.name != "P"',
        'mark.letter in ("H", "H_S")',
        'found = [m for m in marks if m.letter.startswith("(n_")]',
        'step.uses[1].name == "q"',
        'view.pole.name in ("p", "π")',
        "labels[step.it.name]",
        "by_letter.get(mark.letter)",
        "{force.letter: force for force in forces}",
        'mark.letter.partition("_")',
    ],
)
def test_a_comparison_of_letters_is_seen(line: str) -> None:
    assert list(_found(ast.walk(ast.parse(line))))


@pytest.mark.parametrize(
    "line",
    [
        'draft.draw(lay_off, f"{point.letter}_0", line, length)',
        'f"{distance.name} = {value}"',
        "step.it.role == roles.POLE",
        "step.op.name in KEPT",
        "image.letter.lower()",
        "group.name in sides",
    ],
)
def test_naming_by_a_letter_is_no_comparison(line: str) -> None:
    assert not list(_found(ast.walk(ast.parse(line))))


def test_no_code_compares_letters() -> None:
    found = {
        f"{path.relative_to(PACKAGE).as_posix()}: {text}"
        for path in sources()
        for text in _found(nodes(path))
    }
    assert found - ALLOWED == set(), "give the mark a role, or hold the mark itself"
    assert ALLOWED - found == set(), "allowed, but not there any more"
