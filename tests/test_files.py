"""Files are written whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from graphic_tmm.errors import SheetError
from graphic_tmm.files import write


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
        if "second" in path.name:
            plain(path, data[:2])
            raise trouble
        return plain(path, data)

    monkeypatch.setattr(Path, "write_bytes", fails)
    told = SheetError if isinstance(trouble, OSError) else KeyboardInterrupt
    with pytest.raises(told):
        write(tmp_path / "new" / "folder", {"first.svg": "abc", "second.svg": "abc"})
    assert found(tmp_path) == {}
    (tmp_path / "first.svg").write_text("old")
    with pytest.raises(told):
        write(tmp_path, {"first.svg": "abc", "second.svg": "abc"})
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
