"""The package as a whole: public names, words on every operation, the command line as a process."""

from __future__ import annotations

import os
import pkgutil
import string
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
from support.each import each
from support.gallery import ROOT

import graphic_tmm
from graphic_tmm.board.grammar import OPERATIONS

ROOMS = [
    import_module(one.name)
    for one in pkgutil.walk_packages(graphic_tmm.__path__, "graphic_tmm.")
    if not one.name.endswith("__main__")
]


def test_public_names_are_sorted_complete_and_there() -> None:
    assert graphic_tmm.__all__ == sorted(graphic_tmm.__all__)
    assert set(graphic_tmm.__all__) == set(graphic_tmm._HOMES)
    for name in graphic_tmm.__all__:
        assert getattr(graphic_tmm, name).__name__ == name
    with pytest.raises(AttributeError):
        _ = graphic_tmm.nonsense


def _placeholders(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name}


@each("op", OPERATIONS.values())
def test_an_operation_has_a_sentence_that_names_its_marks(op) -> None:
    assert op.sentence
    assert _placeholders(op.sentence) <= {*op.arguments, *op.choices, "it"}
    if _placeholders(op.sentence) & set(op.choices):
        assert op.sides != ("+", "−")
    if op.formula:
        assert _placeholders(op.formula) == set(op.arguments)
    if "side" in op.arguments:
        assert op.sides != ("+", "−")
        assert "side" in _placeholders(op.sentence)
    for gap in op.gaps:
        assert _placeholders(gap.says) <= set(op.arguments)


def test_every_operation_is_in_the_table() -> None:
    made = {
        v.name for room in ROOMS for v in vars(room).values() if type(v).__name__ == "Operation"
    }
    assert made == set(OPERATIONS)


# the command line


def outcome(*arguments: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "graphic_tmm", *arguments],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        check=False,
    )


@pytest.mark.slow
def test_a_broken_pipe_leaves_no_traceback() -> None:
    name = "planetary"
    for arguments in (("table", name), ("steps", name), ("table", name, "-f", "json")):
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run(
            [sys.executable, "-m", "graphic_tmm", *arguments],
            cwd=ROOT,
            stdout=writer,
            stderr=subprocess.PIPE,
            check=False,
        )
        os.close(writer)
        assert done.returncode != 0
        assert done.stderr == b""


@pytest.mark.slow
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_device_is_told() -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "graphic_tmm", "table", "planetary", "-f", "csv"],
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert done.returncode != 0
    assert b"Traceback" not in done.stderr
    assert "на диске нет места" in done.stderr.decode()


@pytest.mark.slow
@pytest.mark.parametrize(
    "arguments", [["--help"], ["draw", "--help"], ["table", "-h"], ["--version"], ["scenes"]]
)
def test_help_and_scenes_import_nothing_heavy(arguments: list[str]) -> None:
    code = (
        "import sys; from click.testing import CliRunner; from graphic_tmm.__main__ import main;"
        f"done = CliRunner().invoke(main, {arguments!r});"
        "assert done.exit_code == 0, done.output;"
        "print(*sorted({'shapely', 'matplotlib', 'svgwrite', 'rich'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=True, text=True
    )
    assert done.stdout.strip() == ""


def test_help_is_light() -> None:
    code = (
        "import sys; from click.testing import CliRunner; from graphic_tmm.__main__ import main;"
        "assert CliRunner().invoke(main, ['--help']).exit_code == 0;"
        "heavy = {'numpy', 'shapely', 'matplotlib', 'svgwrite', 'rich'} & set(sys.modules);"
        "assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)


@pytest.mark.slow
def test_drawing_sheets_imports_no_page(tmp_path: Path) -> None:
    code = (
        "import sys; from click.testing import CliRunner; from graphic_tmm.__main__ import main;"
        f"done = CliRunner().invoke(main, ['draw', 'lettering', '-o', {str(tmp_path)!r}]);"
        "assert done.exit_code == 0, done.output;"
        "print(*sorted(n for n in sys.modules if n.startswith('graphic_tmm.page.')))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=True, text=True
    )
    assert done.stdout.strip() == ""


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("arguments", [("table", "planetary"), ("steps", "planetary"), ("scenes",)])
def test_what_is_printed_does_not_depend_on_hash_or_locale(arguments: tuple[str, ...]) -> None:
    first, second = (
        outcome(*arguments, PYTHONHASHSEED=seed, LC_ALL=locale, PYTHONIOENCODING=coding)
        for seed, locale, coding in (("0", "C", "ascii"), ("1", "C.UTF-8", "utf-8"))
    )
    assert (first.returncode, first.stderr) == (0, b"")
    assert first.stdout == second.stdout
    assert "планетарный" in first.stdout.decode("utf-8") or arguments[0] == "steps"


@pytest.mark.slow
def test_the_same_bytes_whatever_the_hash_and_the_locale(tmp_path: Path) -> None:
    written = []
    for seed, locale in (("0", "C"), ("1", "C.UTF-8")):
        out = tmp_path / seed
        environment = {**os.environ, "PYTHONHASHSEED": seed, "LC_ALL": locale}
        command = [sys.executable, "-m", "graphic_tmm", "draw", "crank-rocker", "-o", str(out)]
        subprocess.run(command, check=True, env=environment, capture_output=True, cwd=ROOT)
        written.append({p.name: p.read_bytes() for p in out.iterdir()})
    assert written[0] == written[1]
    assert len(written[0]) == 3


@pytest.mark.slow
def test_a_name_in_no_encoding_is_told_without_a_traceback(tmp_path: Path) -> None:
    for what in (b"\xff", "\ud83d".encode("utf-8", "surrogatepass")):
        done = outcome("draw", os.fsdecode(what), "-o", str(tmp_path / "out"))
        assert done.returncode == 2
        assert b"Traceback" not in done.stderr
        assert b"there is no such file" in done.stderr
    place = os.fsdecode(bytes(tmp_path) + b"/\xff")
    done = outcome("draw", "planetary", "-o", place)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout == bytes(tmp_path) + b"/\xff/planetary.svg\n"
