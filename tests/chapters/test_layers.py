"""Inside a chapter imports go down: what is shown, told and judged -> what is drawn -> formulas -> the task.

A refusal that a task asks of its plan is imported when it is asked.
"""

from __future__ import annotations

import ast
from pathlib import Path

from support.each import each
from support.gallery import ROOT

BOOK = ROOT / "graphic_tmm" / "chapters"
CHAPTERS = sorted(path.parent.name for path in BOOK.glob("*/__init__.py"))
LAYERS = (
    ("task", "kinds"),
    ("sections", "formulas", "rack", "operations", "rolling", "words"),
    (),  # plans: what no other layer names
    ("record",),
    ("scales", "outline", "ink", "accuracy"),
    ("live_scales",),
    ("table", "views", "turning", "moving", "scheme", "findings"),
    ("note", "task_sheet"),
    ("__init__",),
)


def layer(name: str) -> int:
    for own in (name, name.partition("_")[0]):
        for k, names in enumerate(LAYERS):
            if own in names:
                return k
    return 2


def imports(path: Path, chapter: str) -> set[str]:
    home = f"graphic_tmm.chapters.{chapter}"
    found = set()
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module:
            if node.module == home:
                found |= {
                    one.name for one in node.names if (path.parent / f"{one.name}.py").exists()
                }
            elif node.module.startswith(f"{home}."):
                found.add(node.module.removeprefix(f"{home}."))
    return found


@each("chapter", CHAPTERS)
def test_imports_of_a_chapter_go_down(chapter: str) -> None:
    wrong = [
        f"{path.stem} imports {other}"
        for path in sorted((BOOK / chapter).glob("*.py"))
        for other in sorted(imports(path, chapter))
        if layer(other) > layer(path.stem)
    ]
    assert not wrong
