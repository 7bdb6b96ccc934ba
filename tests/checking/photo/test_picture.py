from __future__ import annotations

import struct
import sys
import warnings
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from graphic_tmm.checking.photo.picture import read_photo
from graphic_tmm.errors import SceneError, SheetError


def chunk(name: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def header(columns: int, rows: int) -> bytes:
    """A PNG that promises many pixels and has none."""
    size = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", size)
        + chunk(b"IDAT", b"\0" * 10)
        + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize(
    ("columns", "rows"), [(10_001, 10_000), (20_000, 10_000), (60_000, 60_000), (1, 100_000_001)]
)
def test_more_than_100_megapixels_are_refused_before_they_are_read(
    tmp_path: Path, columns: int, rows: int
) -> None:
    path = tmp_path / "large.png"
    path.write_bytes(header(columns, rows))
    limit, filters = Image.MAX_IMAGE_PIXELS, list(warnings.filters)
    with pytest.raises(SheetError, match="at most 100 megapixels"):
        read_photo(path)
    assert (Image.MAX_IMAGE_PIXELS, warnings.filters) == (limit, filters)


def test_100_megapixels_are_allowed_and_damage_is_told(tmp_path: Path) -> None:
    path = tmp_path / "damaged.png"
    path.write_bytes(header(10_000, 9_999))
    with pytest.raises(SheetError, match="cannot be read"):
        read_photo(path)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"plan,position,segment,mm\n",
        b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 100 100\n",
        b"<svg xmlns='http://www.w3.org/2000/svg'/>",
        b"GIF89a\x01\x00\x01\x00\x00\x00\x00;",
        b"\x89PNG\r\n\x1a\n",
        b"\xff\xd8\xff",
        bytes(range(256)) * 40,
    ],
)
def test_what_is_no_photograph_is_told(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "photo.jpg"
    path.write_bytes(content)
    with pytest.raises(SheetError, match=r"photo\.jpg: .*(JPEG|PNG)"):
        read_photo(path)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (".", "this is a folder; name a photograph"),
        ("none.png", "there is no such file; name a photograph"),
        ("a" * 5000, "cannot be read"),
        ("/dev/zero", "a device or a pipe, no ordinary file; name a photograph"),
    ],
)
def test_what_is_no_file_is_told(name: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=said):
        read_photo(tmp_path / name)


@pytest.mark.parametrize("form", ["JPEG", "PNG", "TIFF", "WEBP", "BMP"])
def test_a_photograph_cut_short_is_told(tmp_path: Path, form: str) -> None:
    random = np.random.default_rng(1).integers(0, 255, (90, 120, 3), dtype=np.uint8)
    path = tmp_path / "photo"
    Image.fromarray(random).save(path, form)
    assert read_photo(path).shape == (90, 120, 3)
    path.write_bytes(path.read_bytes()[: -path.stat().st_size // 3])
    with pytest.raises(SheetError, match=r"photo: .*(cannot|can) be read"):
        read_photo(path)


def test_every_mode_is_read_as_colours(tmp_path: Path) -> None:
    ramp = np.tile(np.arange(0, 256, 5, dtype=np.uint8), (20, 1))
    due = np.repeat(ramp[..., None], 3, axis=2)
    grey = Image.fromarray(ramp)
    deep = Image.fromarray(ramp.astype(np.uint16) * 257)
    assert deep.mode == "I;16"
    for image in (grey, grey.convert("RGB"), grey.convert("P"), grey.convert("RGBA"), deep):
        image.save(tmp_path / "mode.png")
        assert (read_photo(tmp_path / "mode.png") == due).all(), image.mode
    clear = np.concatenate([due, np.zeros((20, 52, 1), dtype=np.uint8)], axis=2)
    Image.fromarray(clear).save(tmp_path / "clear.png")
    assert (read_photo(tmp_path / "clear.png") == 255).all()
    grey.convert("CMYK").save(tmp_path / "ink.jpg", quality=95)
    assert abs(read_photo(tmp_path / "ink.jpg").astype(int) - due).max() < 12
    grey.convert("1").save(tmp_path / "bits.png")
    assert set(np.unique(read_photo(tmp_path / "bits.png"))) <= {0, 255}


@pytest.mark.parametrize(("orientation", "turn"), [(1, 0), (3, 2), (6, -1), (8, 1)])
def test_a_photograph_stands_as_its_camera_says(
    tmp_path: Path, orientation: int, turn: int
) -> None:
    stored = np.random.default_rng(2).integers(0, 255, (30, 40, 3), dtype=np.uint8)
    said = Image.Exif()
    said[0x0112] = orientation
    Image.fromarray(stored).save(tmp_path / "turned.png", exif=said)
    assert (read_photo(tmp_path / "turned.png") == np.rot90(stored, turn)).all()


def test_without_pillow_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "PIL", None)
    with pytest.raises(SheetError, match=r"graphic-tmm\[photo\]"):
        read_photo(tmp_path / "photo.jpg")
