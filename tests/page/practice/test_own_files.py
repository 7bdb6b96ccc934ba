"""What a file is told to be, by the page's program run by node."""

from __future__ import annotations

import io

from PIL import Image
from support.scripts import run

FORMATS = """
import { formatOf } from "./own/photo.js";
tell(asked.map((bytes) => formatOf(Uint8Array.from(bytes))));
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
