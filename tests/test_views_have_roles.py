"""A view's name is for readers: no code takes it apart to find out what the view is."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from support.messages import nodes, sources

import graphic_tmm

PACKAGE = Path(graphic_tmm.__file__).parent
APART = {"startswith", "endswith", "partition", "rpartition", "split", "rsplit", "find", "index"}
APART |= {"removeprefix", "removesuffix"}
MATCHED = {"match", "fullmatch", "search", "findall", "split", "sub"}
VIEWS = {"view", "drawing", "outline"}
"""What is called so has a name, or is one."""

ALLOWED = {
    # people ask for the words of a name that is made up of links and a pass: there is no log to look it up in
    "chapters/forces/words.py: view.partition(' ')",
    # so they do of a plan by the link of its drive
    "chapters/kinematics/words.py: view.rpartition(' ')",
    # of the static moments of a link
    "chapters/balance/words.py: view.rpartition(' ')",
    # and of a diagram by the letter of its cylinder
    "chapters/indicator/words.py: view.partition(' ')",
    # and of centrodes by the link that rolls
    "chapters/centrodes/words.py: view.partition(' ')",
    # machines call the scale factor of a base by the view that was calculated for
    "readers/table.py: step.it.view.removesuffix('-calculation')",
}


def _is_name(node: ast.expr) -> bool:
    """Whether an expression is the name of a view."""
    if isinstance(node, ast.Name):
        return node.id == "view"
    if not isinstance(node, ast.Attribute):
        return False
    owner = getattr(node.value, "attr", getattr(node.value, "id", ""))
    return node.attr == "view" or (node.attr == "name" and owner in VIEWS)


def _takes_apart(node: ast.AST) -> bool:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr in APART and _is_name(node.func.value):
            return True
        return node.func.attr in MATCHED and any(_is_name(one) for one in node.args)
    if isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.In | ast.NotIn):
        return isinstance(node.left, ast.Constant) and _is_name(node.comparators[0])
    return (
        isinstance(node, ast.Subscript)
        and isinstance(node.slice, ast.Slice)
        and _is_name(node.value)
    )


def _found(nodes: Iterable[ast.AST]) -> Iterator[str]:
    return (ast.unparse(node) for node in nodes if _takes_apart(node))


@pytest.mark.parametrize(
    "line",
    [
        'plan = view.partition("-")[0]',
        'view.name.startswith(("table", "equations"))',
        "any(view.name.endswith(one) for one in others)",
        '"-" in polygon.view',
        'step.it.view.removesuffix("-calculation")',
        're.match("group (.*)", mark.view)',
        "drawing.name[6:]",
    ],
)
def test_a_name_taken_apart_is_seen(line: str) -> None:
    assert list(_found(ast.walk(ast.parse(line))))


@pytest.mark.parametrize(
    "line",
    [
        "view.role == TABLE",
        'view == "loads"',
        "mark.view in views",
        'f"{view.name} small"',
        'view.name.replace(" ", "_")',
        "views[0]",
    ],
)
def test_a_name_used_whole_is_none(line: str) -> None:
    assert not list(_found(ast.walk(ast.parse(line))))


def test_no_code_takes_the_name_of_a_view_apart() -> None:
    found = {
        f"{path.relative_to(PACKAGE).as_posix()}: {text}"
        for path in sources()
        for text in _found(nodes(path))
    }
    assert found - ALLOWED == set(), "give the view a role, or hold the record that says it"
    assert ALLOWED - found == set(), "allowed, but not there any more"
