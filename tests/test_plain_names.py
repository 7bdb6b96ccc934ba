"""Names say what they name: no private words, and a public name stands in few rooms."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from support.gallery import ROOT
from support.messages import nodes, sources

PACKAGE = ROOT / "graphic_tmm"
PRIVATE = {"told", "found", "made", "one", "beside", "asked", "shown", "others"}
"""Words that name nothing by themselves: who searches for them finds everything."""
ROOMS = 3
"""So many rooms may have a public function or class of one name."""
Named = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef


def read() -> Iterator[tuple[Path, Sequence[ast.AST]]]:
    return ((path.relative_to(PACKAGE), nodes(path)) for path in sources())


def private(path: Path, code: Iterable[ast.AST]) -> Iterator[str]:
    """Private words as names: of a file, of functions and classes at any depth."""
    if path.stem in PRIVATE:
        yield str(path)
    for node in code:
        if isinstance(node, Named) and node.name.strip("_").lower() in PRIVATE:
            yield f"{path}: {node.name}"


def test_a_private_word_is_seen() -> None:
    tree = ast.parse("class Asked:\n    def _told(self): ...\n    def retold(self): ...\n")
    assert list(private(Path("one.py"), ast.walk(tree))) == [
        "one.py",
        "one.py: Asked",
        "one.py: _told",
    ]


def test_no_private_word_is_a_name() -> None:
    assert [name for path, code in read() for name in private(path, code)] == []


def test_a_public_name_stands_in_few_rooms() -> None:
    rooms = defaultdict[str, set[str]](set)
    for path, (module, *_) in read():
        assert isinstance(module, ast.Module)
        for node in module.body:
            if isinstance(node, Named) and not node.name.startswith("_"):
                rooms[node.name].add(path.parts[0])
    assert {name: there for name, there in rooms.items() if len(there) > ROOMS} == {}
