"""Files are written whole or not at all."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from support.command import invoke, tabled
from support.gallery import ROOT
from support.scenes import edited, source

from graphic_tmm.errors import SceneError, SheetError
from graphic_tmm.files import HOST, Kind, read, write


def found(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_texts_and_bytes_come_to_their_places_as_they_are(tmp_path: Path) -> None:
    folder = tmp_path / "a" / "b"
    paths = write(folder, {"z.svg": "μ\n", "a.png": b"\r\n\x00"})
    assert paths == (folder / "z.svg", folder / "a.png")
    assert found(folder) == {"z.svg": "μ\n".encode(), "a.png": b"\r\n\x00"}


def test_a_file_that_stands_there_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "x.svg").write_text("a longer text than the new one")
    (tmp_path / "mine.txt").write_text("mine")
    write(tmp_path, {"x.svg": "new"})
    assert found(tmp_path) == {"x.svg": b"new", "mine.txt": b"mine"}


def test_a_folder_in_the_way_leaves_everything_as_it_was(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text("old")
    (tmp_path / "b.svg").mkdir()
    with pytest.raises(SheetError, match="a folder stands there; name another folder"):
        write(tmp_path, {"a.svg": "new", "b.svg": "new"})
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.svg", "b.svg"]
    assert (tmp_path / "a.svg").read_text() == "old"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names")
def test_a_device_or_a_pipe_is_never_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "b.svg")
    with pytest.raises(SheetError, match="a device or a pipe stands there; name another folder"):
        write(tmp_path, {"a.svg": "new", "b.svg": "new"})
    assert [path.name for path in tmp_path.iterdir()] == ["b.svg"]
    assert (tmp_path / "b.svg").is_fifo()


@pytest.mark.parametrize("below", [".", "deep/deeper"])
def test_a_file_where_a_folder_should_be_is_told_with_the_remedy(
    below: str, tmp_path: Path
) -> None:
    wall = tmp_path / "wall"
    wall.write_text("a file")
    with pytest.raises(SheetError, match=r"cannot write into .*wall.*; do this"):
        write(wall / below, {"x.svg": "new"}, remedy="do this")
    assert found(tmp_path) == {"wall": b"a file"}


@pytest.mark.parametrize("trouble", [OSError(28, "No space left on device"), KeyboardInterrupt()])
def test_nothing_is_left_of_files_broken_off_half_way(
    trouble: BaseException, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = Path.write_bytes

    def fails(path: Path, data: bytes) -> int:
        if data == b"second":
            plain(path, data[:2])
            raise trouble
        return plain(path, data)

    monkeypatch.setattr(Path, "write_bytes", fails)
    told = SheetError if isinstance(trouble, OSError) else KeyboardInterrupt
    with pytest.raises(told):
        write(tmp_path / "new" / "folder", {"first.svg": "abc", "second.svg": "second"})
    assert found(tmp_path) == {}
    (tmp_path / "first.svg").write_text("old")
    with pytest.raises(told):
        write(tmp_path, {"first.svg": "abc", "second.svg": "second"})
    assert found(tmp_path) == {"first.svg": b"old"}


def test_a_text_that_is_no_text_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(UnicodeEncodeError):
        write(tmp_path / "new", {"first.svg": "abc", "second.svg": "\ud800"})
    assert found(tmp_path) == {}


def test_a_place_that_will_not_be_replaced_leaves_no_temporary_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuses(source: Path, target: Path) -> None:
        raise PermissionError(13, "Permission denied", str(target))

    monkeypatch.setattr(os, "replace", refuses)
    with pytest.raises(SheetError, match="permission denied"):
        write(tmp_path / "new", {"x.svg": "abc"})
    assert found(tmp_path) == {}


# the command line


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("stand", ["file", "file/below", "proc"])
def test_a_folder_that_cannot_be_written(stand: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("a file")
    out = "/proc/nothing/here" if stand == "proc" else str(tmp_path / stand)
    for command in (("draw", "engine", "-o", out), ("new", out, "--like", "engine")):
        result = invoke(*command, "-l", "en")
        assert result.exit_code == 2, result.output
        assert "cannot write into" in result.stderr
        assert "name another folder" in result.stderr
        # -o is an option of draw, not of new
        assert ("with -o" in result.stderr) == (command[0] == "draw")
        assert result.stdout == ""
    assert (tmp_path / "file").read_text() == "a file"
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


def test_new_begins_a_scene_and_never_overwrites(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    assert invoke("new", str(folder), "--like", "crank-rocker").exit_code == 0
    assert invoke("table", str(folder)).exit_code == 0
    again = invoke("new", str(folder))
    assert again.exit_code == 2
    assert "exists already" in again.stderr


def test_new_copies_nothing_that_is_no_scene(tmp_path: Path) -> None:
    bad = edited(tmp_path, ("[drive]", "[drivel]"))
    for like in ("no-such-scene", str(bad)):
        result = invoke("new", str(tmp_path / "mine"), "--like", like)
        assert result.exit_code == 2
        assert not (tmp_path / "mine").exists()


def test_new_is_a_copy_that_finds_its_schema_and_leaves_a_scene_that_is_there(
    tmp_path: Path,
) -> None:
    names = ("scene.toml", "scene.schema.json")
    assert invoke("new", str(tmp_path)).stdout == "".join(f"{tmp_path / name}\n" for name in names)
    text = (tmp_path / "scene.toml").read_text(encoding="utf-8")
    schema = text.splitlines()[0].removeprefix("#:schema ")
    assert json.loads((tmp_path / schema).read_text(encoding="utf-8"))["properties"]["drive"]
    assert "kept for the poles" in text
    due = source("windrower")
    old = [line for line in due.splitlines() if not line.startswith("#:schema")]
    assert text.splitlines()[2:] == old
    assert "#:schema" not in "\n".join(old)
    (tmp_path / "scene.toml").write_text("mine")
    result = invoke("new", str(tmp_path), "--like", "engine")
    assert (result.exit_code, (tmp_path / "scene.toml").read_text()) == (2, "mine")


def test_a_scene_begun_from_one_that_was_begun_finds_its_own_schema(tmp_path: Path) -> None:
    assert invoke("new", str(tmp_path / "a"), "--like", "cam").exit_code == 0
    assert invoke("new", str(tmp_path / "b"), "--like", str(tmp_path / "a")).exit_code == 0
    made = [(tmp_path / name / "scene.toml").read_text(encoding="utf-8") for name in "ab"]
    assert made[0] == made[1]


def test_threads_that_write_at_once_exchange_nothing(tmp_path: Path) -> None:
    threads, rounds = 8, 40
    begin = threading.Barrier(threads)

    def writes(thread: int) -> None:
        begin.wait(30)
        for number in range(rounds):
            name = f"{thread}-{number}.svg"
            write(tmp_path, {name: name * 500, f"{name}.too": b"too" + name.encode()})

    with ThreadPoolExecutor(threads) as pool:
        for done in [pool.submit(writes, thread) for thread in range(threads)]:
            done.result()
    names = [f"{thread}-{number}.svg" for thread in range(threads) for number in range(rounds)]
    due = {name: (name * 500).encode() for name in names}
    due |= {f"{name}.too": b"too" + name.encode() for name in names}
    assert found(tmp_path) == due


def test_rights_of_a_file_outlive_it_and_a_new_one_has_those_that_the_mask_leaves(
    tmp_path: Path,
) -> None:
    (tmp_path / "old.svg").write_text("old")
    (tmp_path / "old.svg").chmod(0o640)
    mask = os.umask(0o027)
    try:
        write(tmp_path, {"old.svg": "new", "new.svg": "new"})
    finally:
        os.umask(mask)
    assert {path.name: path.stat().st_mode & 0o777 for path in tmp_path.iterdir()} == {
        "old.svg": 0o640,
        "new.svg": 0o640,
    }
    (tmp_path / "old.svg").chmod(0o604)
    write(tmp_path, {"old.svg": "newer"})
    assert (tmp_path / "old.svg").stat().st_mode & 0o777 == 0o604


# what a killed run has left


PART = ".graphic-tmm-{}-{}-0.part"


def test_what_a_dead_process_has_left_is_taken_away_by_the_next(tmp_path: Path) -> None:
    ended = subprocess.run(
        [sys.executable, "-c", "import os; print(os.getpid())"], capture_output=True
    )
    dead = int(ended.stdout)
    kept = [
        PART.format(HOST, os.getppid()),  # it lives
        PART.format("other-machine", dead),
        f".mine.{dead}.part",
        f"graphic-tmm-{HOST}-{dead}-0.part",
    ]
    for name in (*kept, PART.format(HOST, dead)):
        (tmp_path / name).write_text("half")
    write(tmp_path, {"x.svg": "new"})
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([*kept, "x.svg"])


@pytest.mark.skipif(os.name != "posix", reason="kill -9 is of POSIX")
def test_a_killed_run_leaves_nothing_once_another_has_written(tmp_path: Path) -> None:
    code = (
        "import os, signal; from graphic_tmm import files;"
        "os.replace = lambda a, b: os.kill(os.getpid(), signal.SIGKILL);"
        f"files.write(files.Path({str(tmp_path)!r}), {{'a.svg': 'new', 'b.svg': 'new'}})"
    )
    killed = subprocess.run([sys.executable, "-c", code], cwd=ROOT)
    assert killed.returncode == -9
    assert len(list(tmp_path.iterdir())) == 2
    write(tmp_path, {"c.svg": "whole"})
    assert found(tmp_path) == {"c.svg": b"whole"}


def test_files_that_are_being_put_in_their_places_get_there_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ctrl-C between two of them: the sheets of one drawing are all old or all new."""
    plain, calls = os.replace, []

    def broken_off(source: Path, target: Path) -> None:
        calls.append(target)
        if len(calls) == 2:
            raise KeyboardInterrupt
        plain(source, target)

    for name in "abc":
        (tmp_path / name).write_text("old")
    monkeypatch.setattr(os, "replace", broken_off)
    with pytest.raises(KeyboardInterrupt):
        write(tmp_path, dict.fromkeys("abc", "new"))
    assert found(tmp_path) == dict.fromkeys("abc", b"new")


# what is read


KIND = Kind("a thing", "name a thing", 1000)


def test_a_file_as_large_as_it_may_be_is_read_and_no_larger(tmp_path: Path) -> None:
    file = tmp_path / "thing"
    file.write_bytes(b"x" * 1000)
    assert read(file, KIND) == b"x" * 1000
    file.write_bytes(b"x" * 1001)
    with pytest.raises(SceneError, match="too large: a thing has at most 1 kB; name a thing"):
        read(file, KIND)


def test_no_device_pipe_or_folder_is_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("/dev/zero")
    for name in ("pipe", "/dev/zero", "/dev/null", "link"):
        with pytest.raises(SceneError, match="a device or a pipe, no ordinary file; name a thing"):
            read(tmp_path / name, KIND)
    with pytest.raises(SceneError, match="this is a folder; name a thing"):
        read(tmp_path, KIND)
    with pytest.raises(SceneError, match="there is no such file; name a thing"):
        read(tmp_path / "none", KIND)


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="no files of unknown size")
def test_a_file_that_does_not_tell_its_size_is_cut_at_the_limit() -> None:
    with pytest.raises(SceneError, match="too large"):
        read(Path("/proc/self/maps"), KIND)


@pytest.mark.slow
def test_draw_writes_every_format_asked_for(tmp_path: Path) -> None:
    result = invoke("draw", "crank-rocker", "-o", str(tmp_path), "-f", "svg, PDF,png,dxf")
    assert result.exit_code == 0, result.output
    starts = {"svg": b"<svg", "pdf": b"%PDF", "png": b"\x89PNG", "dxf": b"  0"}
    found = sorted(path.name for path in tmp_path.iterdir())
    due = [f"crank-rocker-{k}.{form}" for k in (1, 2, 3) for form in ("svg", "png", "dxf")]
    assert found == sorted([*due, "crank-rocker.pdf"])
    assert sorted(Path(line).name for line in result.stdout.splitlines()) == found
    for path in tmp_path.iterdir():
        assert path.read_bytes().startswith(starts[path.suffix[1:]]), path.name


@pytest.mark.slow
def test_letters_of_a_dxf_are_text_or_strokes_as_is_asked_for(tmp_path: Path) -> None:
    for options, text in (((), True), (("--strokes",), False)):
        assert (
            invoke("draw", "crank-rocker", "-o", str(tmp_path), "-f", "dxf", *options).exit_code
            == 0
        )
        for path in tmp_path.iterdir():
            assert ("\nTEXT\n" in path.read_text(encoding="utf-8")) is text


@pytest.mark.slow
def test_a_scene_that_is_a_file_of_another_name_names_its_sheet(tmp_path: Path) -> None:
    path = edited(tmp_path).rename(tmp_path / "мой двигатель.toml")
    assert invoke("draw", str(path), "-o", str(tmp_path / "out")).exit_code == 0
    assert [p.name for p in (tmp_path / "out").iterdir()] == ["мой двигатель.svg"]
    assert tabled(str(path))["scene"] == "мой двигатель"


@pytest.mark.slow
def test_an_unreadable_file_and_an_unwritable_folder(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_bytes(b"\xff\xfe\x00")
    result = invoke("draw", str(tmp_path), "-o", str(tmp_path / "out"))
    assert (result.exit_code, "UTF-8" in result.stderr) == (2, True)
    wall = tmp_path / "wall"
    wall.write_text("a file")
    result = invoke("draw", "engine", "-o", str(wall / "out"), "-l", "en")
    assert result.exit_code == 2
    assert "cannot write into" in result.stderr
    assert "-o" in result.stderr
    assert wall.read_text() == "a file"
