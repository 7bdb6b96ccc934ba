"""Late imports: nothing is imported before it is used; all is there, and takes what it is given."""

from __future__ import annotations

import ast
import builtins
import inspect
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest
from support.gallery import ROOT

import graphic_tmm
from graphic_tmm.chapter import Place, Size, chapters
from graphic_tmm.late import Late, late
from graphic_tmm.varied import Accuracy

LIGHT = {"captions", "names", "task", "sections", "kinds"}
"""What of a chapter is there as soon as chapters are looked for."""
LEFT = {"shapely", "svgwrite", "rich", "jinja2", "matplotlib"}
ROOMS = """
import sys
from pathlib import Path
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.scales import usual
from graphic_tmm.readers.table import table
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make
scene = read(Path(sys.argv[1]))
print(len(table(make(scene, given=Composition(usual(scene), ())), "csv")) > 200, *sys.modules)
"""


PACKAGE = Path(graphic_tmm.__file__).parent


def loaded(name: str) -> set[str]:
    """The modules that a fresh process has imported once it has made the table of a scene in known sizes."""
    done = subprocess.run(
        [sys.executable, "-c", ROOMS, str(ROOT / "sheets" / name / "scene.toml")],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    said, *found = done.stdout.split()
    assert said == "True"
    return set(found)


def test_a_table_of_plans_loads_no_other_chapter_and_no_paper() -> None:
    found = loaded("crank-rocker")
    rooms = {name for name in found if name.startswith("graphic_tmm.chapters.")}
    assert "graphic_tmm.chapters.kinematics.plan" in rooms
    beyond = {name for name in rooms if name.count(".") > 2 and name.split(".")[3] not in LIGHT}
    assert {name.split(".")[2] for name in beyond} == {"kinematics", "structure"}
    assert not {name.split(".")[3] for name in beyond} & {"note", "asks", "views", "accuracy"}
    assert not LEFT & found
    closed = (
        "graphic_tmm.note",
        "graphic_tmm.page",
        "graphic_tmm.accuracy",
        "graphic_tmm.paper.compose",
    )
    assert not [name for name in found if name.startswith(closed)]


def hooks(declared: object) -> Iterator[tuple[str, Late, int]]:
    """What comes late of a declaration: where, what, and with how many arguments it is called."""
    for one in fields(declared):  # type: ignore[arg-type]
        value = getattr(declared, one.name)
        inner = value if isinstance(value, tuple) else (value,)
        for part in inner:
            if isinstance(part, (Place, Size)):
                yield from hooks(part)
        if isinstance(value, Late):
            told = ast.parse(str(one.type), mode="eval").body
            taken = [node for node in ast.walk(told) if isinstance(node, ast.List)][:1]
            yield one.name, value, len(taken[0].elts) if taken else -1


ALL = [(one.name, *hook) for one in chapters() for hook in hooks(one)]


@pytest.mark.parametrize(
    ("chapter", "field", "hook", "count"), ALL, ids=[f"{one[0]}-{one[1]}-{one[2]!r}" for one in ALL]
)
def test_what_a_chapter_names_is_there_and_takes_what_it_is_given(
    chapter: str, field: str, hook: Late, count: int
) -> None:
    found: Any = hook.it()
    if count < 0:
        assert isinstance(found, Accuracy), (chapter, field)
        return
    inspect.signature(found).bind(*range(count))


def test_a_name_that_is_not_there_is_told_with_its_module() -> None:
    with pytest.raises(ImportError, match=r"'nowhere' from 'graphic_tmm\.late'"):
        Late("graphic_tmm.late", "nowhere").it()
    with pytest.raises(ModuleNotFoundError, match="nowhere"):
        Late("graphic_tmm.nowhere", "it")()


def test_only_the_package_that_says_so_imports_late() -> None:
    usual = builtins.__import__
    with late("nobody.of.this.name"):
        from graphic_tmm.files import write
    assert not isinstance(write, Late)
    with late(__name__):
        from graphic_tmm.files import told_elsewhere  # type: ignore[attr-defined]
    assert isinstance(told_elsewhere, Late)
    assert repr(told_elsewhere) == "<late graphic_tmm.files.told_elsewhere>"
    assert builtins.__import__ is usual


def test_imports_are_as_usual_again_after_a_fault() -> None:
    usual = builtins.__import__
    with pytest.raises(ZeroDivisionError), late(__name__):
        raise ZeroDivisionError
    assert builtins.__import__ is usual


def test_what_comes_late_is_what_it_would_have_been() -> None:
    with late(__name__):
        from graphic_tmm.language.numbers import number
        from graphic_tmm.varied import NOTHING
    assert number(0.25, "ru") == "0,25"
    assert NOTHING.places == ()
    with pytest.raises(AttributeError, match="nothing_so"):
        NOTHING.nothing_so  # type: ignore[attr-defined]  # noqa: B018


@pytest.mark.parametrize("name", [one.name for one in chapters()])
def test_no_function_of_a_declaration_uses_a_late_name_that_a_module_of_it_has(name: str) -> None:
    # once a module of a package is imported, its name in the package means the module
    room = PACKAGE / "chapters" / name
    tree = ast.parse((room / "__init__.py").read_text(encoding="utf-8"))
    modules = {path.stem for path in room.glob("*.py")}
    taken = {
        one.asname or one.name
        for block in tree.body
        if isinstance(block, ast.With)
        for line in block.body
        if isinstance(line, ast.ImportFrom) and line.module != f"graphic_tmm.chapters.{name}"
        for one in line.names
    }
    used = {
        inner.id
        for node in ast.walk(tree)
        if isinstance(node, (ast.Lambda, ast.FunctionDef))
        for inner in ast.walk(node)
        if isinstance(inner, ast.Name)
    }
    assert not used & taken & modules
