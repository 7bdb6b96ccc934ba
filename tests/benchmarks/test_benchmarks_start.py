"""Benchmarks can start: each is imported, and every call in it of what is imported is one that can be made.

Nobody runs them every day, and what they call goes on changing.
"""

from __future__ import annotations

import ast
import inspect
import os
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from subprocess import run
from types import ModuleType

import pytest
from support.each import each

SCRIPTS = sorted(
    path.stem for path in Path(__file__).parent.glob("*.py") if not path.stem.startswith("test_")
)


def refused(text: str, within: ModuleType) -> Iterator[str]:
    """Yield the calls of a text that what is called would refuse; ``within``: what its names mean."""
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, ast.Call):
            continue
        try:
            signature = inspect.signature(called(node.func, within))
        except (AttributeError, TypeError, ValueError):
            continue  # of a local name, or of what has no signature
        starred = any(isinstance(one, ast.Starred) for one in node.args)
        named = {one.arg: None for one in node.keywords if one.arg is not None}
        whole = not starred and all(one.arg is not None for one in node.keywords)
        given = () if starred else node.args
        try:
            (signature.bind if whole else signature.bind_partial)(*given, **named)
        except TypeError as error:
            yield f"line {node.lineno}: {ast.unparse(node.func)}: {error}"


def called(node: ast.expr, within: ModuleType) -> object:
    """Return what a name stands for, dots in it too; AttributeError if it is none of the module's."""
    if isinstance(node, ast.Attribute):
        return getattr(called(node.value, within), node.attr)
    if isinstance(node, ast.Name):
        return getattr(within, node.id)
    raise AttributeError


@each("name", SCRIPTS)
def test_a_benchmark_can_start(name: str) -> None:
    module = import_module(f"benchmarks.{name}")
    text = (Path(__file__).parent / f"{name}.py").read_text("utf-8")
    assert list(refused(text, module)) == []


STARTED = """
import os, runpy, sys
import graphic_tmm.studio, numpy
home, *scripts = sys.argv[1:]
for script in scripts:
    if (child := os.fork()) == 0:
        sys.path.insert(0, home)
        sys.argv = [f"{home}/{script}.py"]
        runpy.run_path(sys.argv[0], run_name="started")
        os._exit(0)
    if os.waitpid(child, 0)[1]:
        print(script)
"""
"""Starts scripts as `python tests/benchmarks/NAME.py` does, up to their work; prints those that cannot."""


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="each is started in a fork of what it imports")
def test_each_starts_as_a_script_of_its_own() -> None:
    """What it imports is found from its own folder alone, not because tests stand beside it on the path."""
    home = Path(__file__).parent
    shown = run([sys.executable, "-I", "-c", STARTED, str(home), *SCRIPTS], capture_output=True)
    assert (shown.stdout.decode(), shown.returncode) == ("", 0), shown.stderr.decode()[-2000:]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("bounds(1)\n", 0),
        ("bounds()\n", 1),
        ("bounds(1, near=True)\n", 1),
        ("bounds(*some)\nbounds(**some)\nlocal(1, 2, 3)\n", 0),
        ("bounds(*some, near=True)\n", 1),
        ("drawing.bounds(1, 2)\n", 0),
    ],
)
def test_what_cannot_be_called_so_is_found(text: str, count: int) -> None:
    within = ModuleType("made")
    within.bounds = lambda drawing: drawing  # type: ignore[attr-defined]
    assert len(list(refused(text, within))) == count


def test_every_fault_to_be_planted_can_be() -> None:
    """Its words stand once in a file that is there, and tests are near."""
    faults = import_module("planted_faults").planted()
    assert len(faults) == 60
    assert all(fault.right != fault.wrong and fault.tests for fault in faults)
