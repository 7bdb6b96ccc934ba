"""Machine code hangs on the text, the machine and the translator; it goes when nobody has it."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import weakref
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from graphic_tmm.board.compile import machine as module
from graphic_tmm.board.compile.llvm import loop_of
from graphic_tmm.board.compile.machine import (
    FORMAT,
    VARIABLE,
    Run,
    folder,
    function_of,
    kept,
    machine,
    translated,
)
from graphic_tmm.board.compile.tape import Tape


def _text(factor: float) -> str:
    tape = Tape()
    return loop_of(tape, [(tape.plain(tape.times(tape.input(moving=True), factor)),)]).text


def _doubled(run: Run) -> None:
    row, out, still = np.arange(9.0), np.zeros(9), np.zeros(0)
    for base in (0, 64):
        rows = [row.ctypes.data - base, out.ctypes.data - base]
        frame = np.array([0, 9, still.ctypes.data, *rows], np.int64)
        out[:] = 0.0
        run.call(frame.ctypes.data, base)
        np.testing.assert_array_equal(out, 2.0 * row)


def test_a_text_is_made_once() -> None:
    assert function_of(_text(2.0)) is function_of(_text(2.0))
    _doubled(function_of(_text(2.0)))


def test_the_same_text_gives_the_same_code() -> None:
    assert translated(_text(2.0)) == translated(_text(2.0))
    assert translated(_text(2.0)) != translated(_text(3.0))


def test_the_key_tells_all_that_the_code_hangs_on() -> None:
    here = machine()
    others = (
        here._replace(processor="another"),
        here._replace(features=here.features + ",+more"),
        here._replace(triple="another"),
    )
    keys = {one.key("text") for one in (here, *others)} | {here.key("other text")}
    assert len(keys) == 5


def test_code_goes_with_its_function() -> None:
    run = Run(translated(_text(2.0)))
    _doubled(run)
    seen = weakref.ref(run._loader)
    del run
    gc.collect()
    assert seen() is None


NAME, CODE = "ab" * 32, b"the code"
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="who may write is not told there")


def _never() -> bytes:
    raise AssertionError("it lies there")


def _file(place: Path) -> Path:
    (found,) = place.glob("*.loop")
    return found


def test_it_is_made_once(tmp_path: Path) -> None:
    place = tmp_path / "a" / "b"
    assert kept(NAME, lambda: CODE, place) == CODE
    assert kept(NAME, _never, place) == CODE
    assert kept("cd" * 32, lambda: b"other", place) == b"other"
    assert len(list(place.iterdir())) == 2


@pytest.mark.parametrize(
    "spoil",
    [
        lambda whole: b"",
        lambda whole: whole[:-1],
        lambda whole: whole[: len(FORMAT) + 3],
        lambda whole: whole[:-1] + b"!",
        lambda whole: whole + b"!",
        lambda whole: whole.replace(b"loop 1", b"loop 0"),
        lambda whole: whole[len(FORMAT) + 32 :],
    ],
)
def test_a_damaged_file_is_made_anew(spoil: Callable[[bytes], bytes], tmp_path: Path) -> None:
    kept(NAME, lambda: CODE, tmp_path)
    file = _file(tmp_path)
    file.write_bytes(spoil(file.read_bytes()))
    assert kept(NAME, lambda: b"anew", tmp_path) == b"anew"
    assert kept(NAME, _never, tmp_path) == b"anew"


def test_the_code_of_another_name_is_not_taken(tmp_path: Path) -> None:
    """A file that was renamed, as one of another processor's would be."""
    kept(NAME, lambda: CODE, tmp_path)
    _file(tmp_path).rename(tmp_path / f"{'cd' * 32}.loop")
    assert kept("cd" * 32, lambda: b"anew", tmp_path) == b"anew"


@POSIX
def test_a_link_is_not_followed(tmp_path: Path) -> None:
    place, elsewhere = tmp_path / "loops", tmp_path / "elsewhere"
    kept(NAME, lambda: CODE, elsewhere)
    place.mkdir(0o700)
    (place / f"{NAME}.loop").symlink_to(_file(elsewhere))
    assert kept(NAME, lambda: b"anew", place) == b"anew"
    assert not _file(place).is_symlink()
    assert _file(elsewhere).is_file()


@POSIX
@pytest.mark.parametrize("mode", [0o770, 0o707])
def test_a_folder_or_a_file_where_others_write_is_refused(mode: int, tmp_path: Path) -> None:
    place = tmp_path / "loops"
    kept(NAME, lambda: CODE, place)
    _file(place).chmod(mode)
    assert kept(NAME, lambda: b"anew", place) == b"anew"
    place.chmod(mode)
    assert kept(NAME, lambda: b"made again", place) == b"made again"
    place.chmod(0o700)
    assert kept(NAME, _never, place) == b"anew"


@POSIX
def test_a_folder_of_another_user_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept(NAME, lambda: CODE, tmp_path)
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert kept(NAME, lambda: b"anew", tmp_path) == b"anew"


@POSIX
def test_the_folder_is_the_users_alone(tmp_path: Path) -> None:
    place = tmp_path / "loops"
    kept(NAME, lambda: CODE, place)
    assert place.stat().st_mode & 0o777 == 0o700
    assert _file(place).stat().st_mode & 0o777 == 0o600


def test_where_nothing_can_be_written_it_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("no folder")
    for _ in range(2):
        assert kept(NAME, lambda: CODE, tmp_path / "file") == CODE
        assert kept(NAME, lambda: CODE, tmp_path / "file" / "below") == CODE
        assert kept(NAME, lambda: CODE, None) == CODE

    def full(*_: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr(os, "replace", full)
    assert kept(NAME, lambda: CODE, tmp_path / "loops") == CODE
    assert list((tmp_path / "loops").iterdir()) == []


def test_the_oldest_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST", 3)
    (tmp_path / "left behind.part").write_bytes(b"half")
    (tmp_path / "somebody's.txt").write_text("mine")
    os.utime(tmp_path / "left behind.part", (1, 1))
    for k in range(5):
        name = f"{k}" * 64
        kept(name, lambda: CODE, tmp_path)
        os.utime(tmp_path / f"{name}.loop", (100 + k, 100 + k))
        if k == 3:
            # used again: it is new
            kept("1" * 64, _never, tmp_path)
    found = sorted(file.name[0] for file in tmp_path.glob("*.loop"))
    assert found == ["1", "3", "4"]
    assert not list(tmp_path.glob("*.part"))
    assert (tmp_path / "somebody's.txt").is_file()


@pytest.mark.parametrize(
    ("system", "environ", "due"),
    [
        ("linux", {"HOME": "/home/a"}, "/home/a/.cache/graphic-tmm/loops"),
        ("linux", {"HOME": "/h", "XDG_CACHE_HOME": "/c"}, "/c/graphic-tmm/loops"),
        ("linux", {"HOME": "/h", "XDG_CACHE_HOME": "c"}, "/h/.cache/graphic-tmm/loops"),
        ("darwin", {"HOME": "/Users/a"}, "/Users/a/Library/Caches/graphic-tmm/loops"),
        ("win32", {"LOCALAPPDATA": "/l", "HOME": "/h"}, "/l/graphic-tmm/loops"),
        ("win32", {}, None),
        ("darwin", {}, None),
        ("linux", {}, None),
        ("linux", {"HOME": "/h", VARIABLE: "/mine"}, "/mine"),
        ("linux", {"HOME": "/h", VARIABLE: ""}, None),
    ],
)
def test_where_it_lies(system: str, environ: dict[str, str], due: str | None) -> None:
    assert folder(environ, system) == (None if due is None else Path(due))


RUN = """
import numpy as np
from graphic_tmm.board.compile import machine
from graphic_tmm.board.compile.tape import Tape
from graphic_tmm.board.compile.trace import Value
from support.machine_code import worked

calls = []
translated = machine.translated
machine.translated = lambda text: calls.append(text) or translated(text)
tape = Tape()
x = Value(tape, tape.input(moving=True))
row = np.linspace(0.0, 4.0, 21)[None, :]
(found,) = worked(tape, [x * x], [row])
np.testing.assert_array_equal(found, row * row)
print(len(calls))
"""


@pytest.mark.slow
def test_processes_at_once_and_one_after_them(tmp_path: Path) -> None:
    """However many translate at once, all are right; whoever comes after them translates nothing."""
    environ = {
        **os.environ,
        VARIABLE: str(tmp_path / "loops"),
        "PYTHONPATH": os.pathsep.join(sys.path),
    }

    def started() -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-c", RUN], env=environ, stdout=subprocess.PIPE, text=True
        )

    first = [started() for _ in range(3)]
    assert "1\n" in [process.communicate()[0] for process in first]
    assert [process.returncode for process in first] == [0, 0, 0]
    assert len(list((tmp_path / "loops").iterdir())) == 1
    second = started()
    assert second.communicate()[0] == "0\n"
    assert second.returncode == 0
    _file(tmp_path / "loops").write_bytes(b"damaged")
    third = started()
    assert third.communicate()[0] == "1\n"
    assert third.returncode == 0
