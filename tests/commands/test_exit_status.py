"""How the program ends: 0; 1 only of a check; 2 of bad input; 70 of its own fault; 130 of Ctrl-C; 141."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support.command import invoke
from support.gallery import ROOT
from support.scenes import source

from graphic_tmm.scene import read as reading

ALL = (
    ("draw", "cam"),
    ("table", "cam"),
    ("table", "cam", "-f", "json"),
    ("steps", "cam"),
    ("template", "cam"),
    ("accuracy", "cam", "--trials", "10", "--no-time"),
)
POSIX = pytest.mark.skipif(os.name != "posix", reason="signals are of POSIX")


def failing(error: BaseException) -> Callable[..., Any]:
    def fails(*_: Any, **__: Any) -> Any:
        raise error

    return fails


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("arguments", ALL, ids=" ".join)
@pytest.mark.parametrize(
    "error", [ValueError("of\nnumpy\x1b[31m"), RecursionError("deep"), MemoryError(), KeyError("x")]
)
def test_a_fault_of_the_program_is_told_in_one_line_and_is_never_1(
    arguments: tuple[str, ...], error: Exception, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "read", failing(error))
    monkeypatch.delenv("GRAPHIC_TMM_TRACEBACK", raising=False)
    done = invoke(*arguments, "-l", "en")
    assert (done.exit_code, done.stdout) == (70, "")
    assert done.stderr.count("\n") == 1
    assert done.stderr.rstrip("\n").isprintable()
    told = re.fullmatch(
        r"graphic-tmm: a fault of the program, not of the input \((\w+)(?:: .+)?\); "
        "set GRAPHIC_TMM_TRACEBACK=1 to see where, and report it\n",
        done.stderr,
    )
    assert told
    assert told[1] == type(error).__name__
    assert list(home.iterdir()) == []


def test_where_the_program_is_at_fault_is_shown_on_request(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "read", failing(ValueError("of numpy")))
    monkeypatch.setenv("GRAPHIC_TMM_TRACEBACK", "1")
    done = invoke("table", "cam")
    assert done.exit_code == 70
    assert "Traceback" in done.stderr
    assert "options.py" in done.stderr


@pytest.mark.parametrize("arguments", ALL, ids=" ".join)
def test_ctrl_c_ends_with_130_and_says_nothing(
    arguments: tuple[str, ...], home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "read", failing(KeyboardInterrupt()))
    done = invoke(*arguments)
    assert (done.exit_code, done.stdout, done.stderr.strip()) == (130, "", "")
    assert list(home.iterdir()) == []


@pytest.mark.turns(1)
@pytest.mark.slow
@POSIX
@pytest.mark.parametrize("when", ["os.replace", "files.Path.write_bytes", "files.Path.mkdir"])
def test_a_process_broken_off_while_it_writes_leaves_nothing_half_written(
    when: str, tmp_path: Path
) -> None:
    code = (
        "import os, signal, sys; from graphic_tmm import files; from graphic_tmm.__main__ import main\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have it ignored\n"
        f"plain = {when}\n"
        "def broken(*a, **k):\n"
        "    os.kill(os.getpid(), signal.SIGINT)\n"
        "    return plain(*a, **k)\n"
        f"{when} = broken\n"
        f"main(['draw', 'cam', '-o', {str(tmp_path / 'out')!r}])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True)
    assert (done.returncode, done.stderr.strip()) == (130, b"")
    left = [path.name for path in tmp_path.rglob("*") if path.is_file()]
    assert left in ([], ["cam.svg"])
    if left:
        assert (tmp_path / "out" / "cam.svg").read_text("utf-8").endswith("</svg>\n")


@pytest.mark.turns(2)
@pytest.mark.slow
@POSIX
@pytest.mark.parametrize(
    "arguments",
    [
        ("--help",),
        ("draw", "--help"),
        ("scenes",),
        ("schema",),
        ("table", "crank-rocker"),
        ("table", "crank-rocker", "-f", "csv"),
        ("steps", "crank-rocker"),
        ("template", "crank-rocker"),
    ],
    ids=" ".join,
)
def test_a_reader_who_is_gone_ends_it_quietly(arguments: tuple[str, ...]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "graphic_tmm", *arguments]
    done = subprocess.run(command, cwd=ROOT, stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert (done.returncode, done.stderr) == (128 + signal.SIGPIPE, b"")


@pytest.mark.slow
def test_only_a_check_that_found_something_ends_with_1(tmp_path: Path) -> None:
    csv = tmp_path / "r.csv"
    told = json.loads(invoke("table", "crank-rocker", "--exact", "-f", "json").stdout)
    (due,) = (c for c in told["columns"] if (c["plan"], c["segment"]) == ("velocities", "pb"))
    place = max(range(len(due["mm"])), key=lambda k: due["mm"][k])
    for factor, status in ((1, 0), (10, 1)):
        row = f"velocities,{told['positions'][place]['number']},pb,{factor * due['mm'][place]}"
        csv.write_text(f"plan,position,segment,mm\n{row}\n", encoding="utf-8")
        assert invoke("check", "crank-rocker", str(csv), "--trials", "20").exit_code == status
    assert invoke("nonsense").exit_code == 2
    assert invoke("draw", "--nonsense").exit_code == 2
    assert invoke("draw", "cam", "--seed", "x").exit_code == 2
    assert invoke("--version").exit_code == 0


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("arguments", [("table", "cam"), ("draw", "cam"), ("steps", "cam")])
def test_without_its_docstrings_the_program_refuses_to_speak(
    arguments: tuple[str, ...], tmp_path: Path
) -> None:
    command = [sys.executable, "-OO", "-m", "graphic_tmm", *arguments]
    done = subprocess.run(
        command,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.count("\n") == 1
    assert "run it without -OO" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_without_asserts_the_program_says_the_same() -> None:
    """-O leaves the docstrings; nothing that is told may hang on an assert."""
    words = ("table", "crank-rocker", "--hand", "student")
    here = invoke(*words)
    command = [sys.executable, "-O", "-m", "graphic_tmm", *words]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8")
    assert (done.returncode, done.stdout, done.stderr) == (0, here.stdout, here.stderr)


@pytest.mark.slow
def test_a_warning_does_nothing_to_the_terminal(tmp_path: Path) -> None:
    folder = tmp_path / "a\x1b]0;x\x07\nb"
    folder.mkdir()
    text = source("engine")
    assert 'l  = "0.64 m"' in text
    (folder / "scene.toml").write_text(text.replace('l  = "0.64 m"', 'l  = "0.25 m"'), "utf-8")
    done = invoke("table", str(folder), "-f", "csv", "-l", "en")
    assert done.exit_code == 0
    assert "warning: positions 3, 4, 5" in done.stderr
    assert all(line.isprintable() for line in done.stderr.split("\n"))
    assert r"a\x1b]0;x\x07" in done.stderr
