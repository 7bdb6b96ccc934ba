"""What a file is told to be, and how readings are written down, by the page's program run by node."""

from __future__ import annotations

import io

import pytest
from PIL import Image
from support.scripts import run

from graphic_tmm.checking.readings.writing import write_readings
from graphic_tmm.checking.records import Taken
from graphic_tmm.page.practice.own import own

FORMATS = """
import { formatOf } from "./own/photo.js";
tell(asked.map((bytes) => formatOf(Uint8Array.from(bytes))));
"""
WRITTEN = """
import { csvOf } from "./own/csv.js";
tell(csvOf(asked.rows, asked.pack));
"""


def encoded(kind: str) -> bytes:
    made = io.BytesIO()
    Image.new("RGB", (8, 8), "white").save(made, kind)
    return made.getvalue()


def test_a_file_is_known_by_its_first_bytes() -> None:
    files = {
        "jpeg": encoded("JPEG"),
        "png": encoded("PNG"),
        "webp": encoded("WEBP"),
        "gif": encoded("GIF"),
        "bmp": encoded("BMP"),
        "tiff": encoded("TIFF"),
        "pdf": b"%PDF-1.7\n%\xe2\xe3",
        "heic": b"\0\0\0\x18ftypheic\0\0\0\0mif1heic",
        "avif": b"\0\0\0\x1cftypavif\0\0\0\0mif1",
        "": b"plan,position,segment,mm\n",
    }
    asked = [list(text[:64]) for text in files.values()]
    asked += [list(b"MM\0*\0\0\0\x08"), list(b"\0\0\0\x18ftypmif1\0\0\0\0"), [], [255, 216]]
    assert run(FORMATS, asked) == [*files, "tiff", "heic", "", ""]


@pytest.mark.parametrize("language", ["en", "ru"])
def test_readings_are_written_as_the_check_writes_them(language: str) -> None:
    rows = [
        ["velocities", "3*", "a", "62.395", "-7.398"],
        ["positions", "0", 'B"1', "-0.5", "12.0"],
        ["positions", "a;b,c", "#s", "1.250", "0.001"],
    ]
    told = run(WRITTEN, {"rows": rows, "pack": own((), language)})
    taken = [Taken(*row[:3], x=float(row[3]), y=float(row[4])) for row in rows]
    shortened = told.replace("12,0", "12,0").replace("1.250", "1.25").replace("1,250", "1,25")
    assert shortened == write_readings(taken, language=language)
