"""The public names: there, light, told in docstrings, typed for who checks types, fit to be sent elsewhere."""

from __future__ import annotations

import inspect
import pickle
import re
import subprocess
import sys
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest
from support.each import each
from support.gallery import CASES, ROOT

import graphic_tmm as tmm
from graphic_tmm import errors
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.hand import HANDS, HandName
from graphic_tmm.board.operations import instruments
from graphic_tmm.checking.judging.taken_marks import POINTS
from graphic_tmm.face.checks import Judge, Way

SCRIPT = CASES / "user_script.py"
RECORDS = {"Fault", "Motion", "PointMotion", "Scene"}
"""Records that a user is given and does not make: their docstring tells their fields."""


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_package_that_is_only_imported_is_light() -> None:
    heavy = "{'numpy', 'shapely', 'svgwrite', 'rich', 'jinja2', 'importlib.metadata'} & set(sys.modules)"
    assert run(f"import sys, graphic_tmm; dir(graphic_tmm); print({heavy})") == "set()\n"


@pytest.mark.slow
def test_reading_and_figures_need_no_matplotlib_and_no_pandas() -> None:
    code = (
        "import sys, graphic_tmm as t; d = t.draw('crank-rocker'); d.table('velocities').to_records();"
        "d.steps('velocities', 1); t.Board(); print({'matplotlib', 'pandas', 'IPython'} & set(sys.modules))"
    )
    assert run(code) == "set()\n"


def test_all_names_are_listed_completed_and_imported_by_a_star() -> None:
    assert set(tmm.__all__) < set(dir(tmm))
    found = run(
        "from graphic_tmm import *; print(*sorted(n for n in dir() if n[0] != '_'))"
    ).split()
    assert found == sorted(tmm.__all__)


def test_the_version_is_that_of_the_package() -> None:
    assert tmm.__version__ == version("graphic-tmm")


def test_the_help_names_every_verb() -> None:
    text = tmm.__doc__
    for verb in ("read", "scenes", "draw", "motion", "Board"):
        assert f"tmm.{verb}(" in text
    methods = [name for name, _ in members(tmm.Drawn) if name not in ("scene", "trials", "tables")]
    for name in methods:
        assert re.search(rf"\b{name}\b", text), name


def test_no_public_name_is_that_of_a_module() -> None:
    """Whoever imports ``graphic_tmm.x`` sets ``x`` of the package: a verb of that name would be gone."""
    modules = {path.stem for path in (ROOT / "graphic_tmm").iterdir()}
    assert set(tmm.__all__) & modules == set()


def test_every_error_is_public_and_below_one_root() -> None:
    found = {
        name
        for name, one in vars(errors).items()
        if inspect.isclass(one) and issubclass(one, Exception)
    }
    assert found <= set(tmm.__all__)
    assert all(issubclass(getattr(tmm, name), tmm.TmmError) for name in found)
    assert issubclass(tmm.AbsentError, KeyError)
    assert issubclass(tmm.MissingError, ImportError)


# docstrings


def members(of: type) -> Iterator[tuple[str, Any]]:
    for name, one in inspect.getmembers_static(of):
        if not name.startswith("_") and (callable(one) or isinstance(one, property)):
            yield name, one


def public() -> Iterator[tuple[str, Any]]:
    for name in tmm.__all__:
        one = getattr(tmm, name)
        yield name, one
        if inspect.isclass(one) and one.__module__.startswith("graphic_tmm.face"):
            yield from ((f"{name}.{member}", of) for member, of in members(one) if of.__doc__ != "")


DRAWING = {
    name: one
    for name, one in vars(instruments).items()
    if isinstance(one, Operation) and hasattr(tmm.Board, name)
}
"""The instruments that a board has as methods."""


def own(name: str) -> bool:
    """Whether a name is documented here: not a method of tuples, floats, mappings, nor of an instrument."""
    kind, _, member = name.partition(".")
    if not member:
        return True
    home = next(base for base in getattr(tmm, kind).__mro__ if member in vars(base))
    field = member in getattr(home, "_fields", ())
    return home.__module__.startswith("graphic_tmm.face") and member not in DRAWING and not field


@each("name, one", [(name, one) for name, one in public() if own(name)])
def test_a_public_name_tells_what_it_is_its_parameters_and_its_errors(name, one) -> None:
    text = inspect.getdoc(one)
    assert text
    assert re.match(r"[A-Z].*[.:;]", text.splitlines()[0]), text.splitlines()[0]
    if isinstance(one, property) or (inspect.isclass(one) and issubclass(one, (Exception, tuple))):
        return
    if name in RECORDS:
        return
    parameters = [
        key
        for key in inspect.signature(one).parameters
        if key != "self" and not key.startswith(("_", "args"))
    ]
    told = text.partition("Parameters\n---")[2].partition("\n\n")[0] if parameters else ""
    fields = getattr(one, "__dataclass_fields__", {})
    for key in parameters:
        listed = re.search(rf"(?m)^(\*\*?|.*, )?{key}\b.*( : |$)", text)
        assert key in fields or listed or f"``{key}``" in text, f"{name}: {key} is not told"
    assert told or fields or not parameters, f"{name}: no Parameters"
    if inspect.isclass(one):
        return
    source = inspect.getsource(one)
    raised = set(re.findall(r"\braise (?:tmm\.)?(\w+Error)\(", source))
    assert all(error in text for error in raised), (name, raised)


@each("name, op", DRAWING.items())
def test_an_instrument_is_told_by_the_sentence_of_its_operation(name, op) -> None:
    method = getattr(tmm.Board, name)
    text = " ".join(inspect.getdoc(method).partition("\n\n")[0].split())
    sentence = op.sentence.replace("{", "`").replace("}", "`").replace("``", "` `")
    assert text.replace("`", "") == sentence.replace("`", "")
    parameters = list(inspect.signature(method).parameters)
    assert parameters == ["self", "letter", *op.arguments, *op.choices]


# types


WRONG = """
import graphic_tmm as tmm
tmm.draw("crank-rocker", hand="studnt")
tmm.Board(hand="studnt")
tmm.draw("crank-rocker").check("readings.csv", hand="exact")
tmm.draw("crank-rocker").check("readings.csv", points="papper")
tmm.motion("crank-rocker", 0.0, plans=["speeds"])
tmm.motion("crank-rocker", 0.0, plans="speeds")
"""


@pytest.mark.slow
def test_users_scripts_are_typed_by_mypy_strict(tmp_path: Path) -> None:
    """A right one has no error and nothing untyped; hands, ways and plans that do not exist are found."""
    wrong = tmp_path / "wrong.py"
    wrong.write_text(WRONG, encoding="utf-8")
    options = ("--strict", "--config-file=", "--cache-dir", tmp_path)
    told = subprocess.run(
        [sys.executable, "-m", "mypy", *options, SCRIPT, wrong],
        cwd=tmp_path,
        env={"PYTHONPATH": str(ROOT), "MYPYPATH": str(ROOT), "PATH": ""},
        capture_output=True,
        text=True,
        check=False,
    ).stdout
    mine = [line for line in told.splitlines() if "user_script.py" in line]
    assert [line for line in mine if ": error:" in line] == [], told
    shown = re.findall(r'user_script\.py:\d+: note: Revealed type is "(.+)"', told)
    assert len(shown) == SCRIPT.read_text(encoding="utf-8").count("\nreveal_type(") + 1
    bare = [one for one in shown if one == "Any" or one.startswith("Any ")]
    assert bare == []
    for due in ("records.Scene", "drawn.Drawn", "tables.Table", "tables.Quantity", "Path"):
        assert any(due in one for one in shown), due
    found = {int(line) for line in re.findall(r"wrong\.py:(\d+): error: ", told)}
    assert found == set(range(3, 9)), told


def test_the_names_that_types_know_are_those_that_there_are() -> None:
    assert get_args(HandName) == tuple(HANDS)
    assert {"exact", *get_args(Judge)} == set(HANDS)
    assert get_args(Way) == tuple(POINTS)


@pytest.mark.slow
def test_a_users_script_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(tmp_path)
    code = SCRIPT.read_text(encoding="utf-8").replace('results["J_fly"]', 'scales["mu_l"]')
    code = code.replace("found.mistakes[0].chance", "found.mistakes")
    exec(compile(code, str(SCRIPT), "exec"), {"__name__": "script"})
    assert {path.name for path in tmp_path.iterdir()} == {"sheet.svg", "page.html", "board.svg"}


# records


@each(
    "one",
    [
        tmm.Quantity(1.5, "m", np.array([1.5, 2.0])),
        tmm.Step(1, "1", "Draw."),
        tmm.Verdict("velocities", "1", "pa", "fine", 1.0, 1.0, 0.0, "mm", 0.0, ""),
        tmm.Mistake("slip", "says", 1.0, "velocities", "1", "pa"),
        tmm.Fault("key", 3, "says"),
        tmm.AbsentError("there is none"),
        tmm.SheetError("no room"),
    ],
)
def test_records_go_to_another_process(one) -> None:
    there = pickle.loads(pickle.dumps(one))
    assert repr(there) == repr(one)
    assert type(there) is type(one)


def test_a_quantity_is_a_float_with_a_unit() -> None:
    one = tmm.Quantity(2.5, "m/s", np.array([2.5, 3.0]))
    assert (one * 2, one + 1, one.value, one.unit) == (5.0, 3.5, 2.5, "m/s")
    assert (str(one), f"{one:.2f}", f"{one}") == ("2.5 m/s", "2.50 m/s", "2.5 m/s")
    assert pickle.loads(pickle.dumps(one)).trials.tolist() == [2.5, 3.0]
    assert tmm.Quantity(3.0).trials.tolist() == [3.0]
    assert repr(tmm.Quantity(3.0)) == "3"
