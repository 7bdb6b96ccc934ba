"""Outside its folder nobody names a chapter of the book, or imports one: so a chapter goes with its folder."""

from __future__ import annotations

import ast
import pkgutil
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
from support.messages import nodes, sources

import graphic_tmm
from graphic_tmm import chapters

PACKAGE = Path(graphic_tmm.__file__).parent
NAMES = tuple(sorted(module.name for module in pkgutil.iter_modules(chapters.__path__)))
SENTENCES = ("said", "_")
"""What is given to these is a text for people, not a name."""

ALLOWED = {
    # paper's own lettering, which the chapter shows specimens of: a layer of a drawing, sentences of errors
    "paper/write/svg.py: 'lettering'",
    "paper/write/dxf.py: 'lettering'",
    "paper/lettering/letters.py: 'lettering cannot stand at ('",
    "paper/lettering/markup.py: 'lettering '",
    # folders of scenes, and mechanisms to begin with, that are called so
    "commands/new.py: 'cam'",
    "commands/new.py: 'engine'",
    # the section of a scene with which weights begin to count, beside a scheme
    "serve/scheme/effects.py: 'forces'",
    # what motion is asked for: a word of the face, and of a place of sheets
    "readers/any_angles/turn.py: 'forces'",
    "readers/any_angles/turn.py: 'cam'",
    "readers/any_angles/turn.py: 'arc_cam'",
    "readers/any_angles/turn.py: 'gears'",
    "readers/any_angles/turn.py: 'centrodes'",
    "readers/any_angles/turn.py: 'curvature'",
    "readers/any_angles/turn.py: 'hodograph'",
    "readers/any_angles/results.py: 'forces'",
    "readers/any_angles/turn.py: 'centres'",
    "readers/any_angles/results.py: 'centres'",
    # the centres of wheels in mesh
    "scene/meshes.py: 'centres'",
    # what balances a drive, as motion tells it: not the balance of masses
    "readers/any_angles/turn.py: 'balance'",
    "readers/any_angles/results.py: 'balance'",
}


def _named(text: object) -> bool:
    return isinstance(text, str) and any(
        text == name or text.startswith(f"{name} ") for name in NAMES
    )


def _imported(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom) and node.module:
        yield from (f"{node.module}.{alias.name}" for alias in node.names)


def _found(code: Sequence[ast.AST]) -> Iterator[str]:
    """Yield the names of chapters in code: texts that are one, or begin with one; what is imported of them."""
    spared = {
        id(part)
        for node in code
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id in SENTENCES
        for part in node.args
    }
    spared |= {id(node.value) for node in code if isinstance(node, ast.Expr)}
    for node in code:
        if isinstance(node, ast.Constant) and id(node) not in spared and _named(node.value):
            yield repr(node.value)
        yield from (name for name in _imported(node) if name.startswith("graphic_tmm.chapters."))


@pytest.mark.parametrize(
    "line",
    [
        'WORDS["cam"]',
        'title = f"cam {view}"',
        'kind in {"forces": 1}',
        'place("engine diagrams")',
        "from graphic_tmm.chapters import gears",
        "from graphic_tmm.chapters.gears.plan import GEARS_PLAN",
        "import graphic_tmm.chapters.gears",
    ],
)
def test_a_name_of_a_chapter_is_seen(line: str) -> None:
    assert list(_found([*ast.walk(ast.parse(line))]))


@pytest.mark.parametrize(
    "line",
    [
        '"camera"',
        '"""Cam and follower."""',
        'said("forces on the pin")',
        '"the cam"',
        "cam = forces",
    ],
)
def test_other_words_are_no_names(line: str) -> None:
    assert not list(_found([*ast.walk(ast.parse(line))]))


def test_nobody_outside_names_a_chapter() -> None:
    found = {
        f"{path.relative_to(PACKAGE).as_posix()}: {name}"
        for path in sources()
        if PACKAGE / "chapters" not in path.parents
        for name in _found(nodes(path))
    }
    assert found - ALLOWED == set(), "declare it on the chapter, or ask the registry"
    assert ALLOWED - found == set(), "allowed, but not there any more"
