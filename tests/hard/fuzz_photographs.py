"""Photographs of sheets and what is told of them, changed at random: each is judged, or refused in a message.

    python tests/hard/fuzz_photographs.py 500 [--seed 0] [--first 0] [--jobs 2]

A case is told by the seed and its number alone: ``--only N`` runs it again and prints its command line.
"""

from __future__ import annotations

import io
import random
import sys
from functools import cache
from typing import NamedTuple

import numpy as np
from fuzz import Case, cased, command
from fuzz_changes import SHEETS, changed_scene, scenes
from fuzz_options import CSV, OUT, PHOTO, SCENE
from fuzz_readings import changed_readings, readings
from fuzz_tasks import Task
from PIL import Image, ImageDraw

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.pencil.expected import views
from graphic_tmm.checking.photo.quadrilaterals import ruled
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

NAMES = ("accelerating-crank", "crank-rocker", "oscillating-cylinder", "slider-diagrams")
"""Scenes of three A4 each: soon drawn, soon flattened."""
DOTS, TABLE = 3, 40
"""Dots of a photograph to the millimetre, and dots of the table about the sheet."""
MODES = ("RGB", "RGB", "RGB", "L", "RGBA", "LA", "P", "1", "CMYK", "YCbCr", "LAB", "I", "F", "I;16")
FORMATS = (*("PNG", "PNG", "JPEG", "JPEG", "TIFF", "WEBP", "BMP"), *("GIF", "PPM", "ICO", "TGA"))
NUMBERS = (
    *("nan", "inf", "-inf", "1e300", "-1e300", "1e308", "-1e308", "1e999", "5e-324", "0", "-0.0"),
    *(
        "-1",
        "-100",
        "1e4",
        "1e5",
        "1e9",
        "",
        " ",
        "x",
        "0x10",
        "1_0",
        "\u0663",
        "5.5",
        "7;8",
        "1,2",
    ),
)
"""What is written for a number of dots."""
PLACES = (
    *(
        "0,0 0,0 0,0 0,0",
        "1,1 2,2 3,3 4,4",
        "0,0 9,0 9,9",
        "0,0 9,0 9,9 0,9 5,5",
        "1,2,3 4,5 6,7 8,9",
    ),
    *("", " ", ",", ", , , ,", "a,b c,d e,f g,h", "nan,nan nan,nan nan,nan nan,nan"),
    *("0,0 1e308,0 1e308,1e308 0,1e308", "-1e308,-1e308 1e308,-1e308 1e308,1e308 -1e308,1e308"),
    *("0,0 1e200,0 1e200,1e200 0,1e200", "0,0 30,0 30,30 0,30", "0,0 500,0 250,21 0,500"),
    *(
        "0,0 600,0 0,800 600,800",
        "0,0 600,0 600,1e-300 0,800",
        "0,0;9,0;9,9;0,9",
        "--sheet",
        "-1,-1",
    ),
)
"""What is written for four corners."""
CHANGED = (*("file",) * 6, *("corners",) * 3, *("pole",) * 3, "sheet", "readings", "scene")
WRITTEN = (*(f"{OUT}/r.csv",) * 6, f"{OUT}/o.svg", f"{OUT}/o-flat.png", PHOTO, SCENE, "")
"""Where the points seen are to be written."""


class Shown(NamedTuple):
    """A sheet as it is photographed, the corners of its frame and the poles of its plans, px."""

    image: Image.Image
    corners: tuple[complex, ...]
    poles: tuple[tuple[str, str, complex], ...]


@cache
def shown(name: str, number: int) -> Shown:
    """Return a sheet of a scene, its lines drawn dark on a table, seen straight from above."""
    made, several = sheets(read(SHEETS / name))
    sheet = several[number - 1]

    def seen(at: complex) -> complex:
        return complex(at.real * DOTS + TABLE, (sheet.height - at.imag) * DOTS + TABLE)

    size = [round(side * DOTS) + 2 * TABLE for side in (sheet.width, sheet.height)]
    image = Image.new("L", (size[0], size[1]), 120)
    drawn = ImageDraw.Draw(image)
    drawn.rectangle((TABLE, TABLE, size[0] - TABLE, size[1] - TABLE), fill=235)
    for stroke in (one for drawing in sheet.drawings for one in drawing.strokes):
        if isinstance(stroke, Stroke):
            path = [seen(complex(x, y)) for x, y, _ in stroke.path]
            path += path[:1] * stroke.closed
            drawn.line([(z.real, z.imag) for z in path], fill=70, width=1 + (DOTS > 3))
    box = ruled(sheet, number == 1).frame
    corners = [complex(x, y) for x in (box.left, box.right) for y in (box.bottom, box.top)]
    poles = {
        (*pole, seen(view.places[at].at))
        for view in views(made, sheet, HANDS["student"])
        for pole, at in view.poles.items()
    }
    return Shown(image, tuple(seen(z) for z in corners), tuple(sorted(poles, key=str)))


# ---------------------------------------------------------------- the file


def picture(source: random.Random, name: str, number: int) -> Image.Image:
    """Return a picture: mostly the sheet, seen well or badly; or nothing that is one."""
    way, whole = source.random(), shown(name, number).image
    if way < 0.35:
        return whole
    if way < 0.6:
        return _worse(source, whole)
    size = source.choice(((1, 1), (2, 2), (3, 2000), (2000, 3), (1, 5000), (30, 20), (640, 480)))
    if way < 0.8:
        return Image.new("L", size, source.choice((0, 1, 19, 128, 254, 255)))
    grain = np.random.default_rng(source.getrandbits(32))
    if way < 0.9:
        return Image.fromarray(grain.integers(0, 256, (size[1], size[0]), dtype=np.uint8))
    image = Image.new("L", (640, 480), 230)
    lines = ImageDraw.Draw(image)
    for at in range(0, 640, source.choice((7, 20, 60))):
        lines.line((at, 0, at, 480), fill=30)
        lines.line((0, at, 640, at), fill=30)
    return image


def _worse(source: random.Random, image: Image.Image) -> Image.Image:
    """Return a photograph turned, cut out, aslant, made smaller, dark, or seen in a mirror."""
    columns, rows = image.size
    cut = [source.randrange(side // 3) for side in (columns, rows)]
    slant = (1.0, source.uniform(-0.2, 0.2), 0.0, 0.0, 1.0, 0.0)
    far = (source.uniform(-6e-4, 6e-4), source.uniform(-6e-4, 6e-4))
    ways = (
        lambda: image.rotate(source.choice((3, 45, 90, 180, 270)), expand=True, fillcolor=90),
        lambda: image.crop((cut[0], cut[1], columns - cut[0] // 2, rows - cut[1] // 2)),
        lambda: image.transform(image.size, Image.Transform.PERSPECTIVE, (*slant, *far)),
        lambda: image.resize((max(columns // source.choice((2, 5, 30)), 1), rows // 3)),
        lambda: image.point([level // source.choice((3, 10, 60)) for level in range(256)]),
        lambda: image.transpose(Image.Transpose.FLIP_LEFT_RIGHT),
    )
    return source.choice(ways)()


def photograph(source: random.Random, name: str, number: int) -> bytes:
    """Return the file of a picture, of some kind; sometimes torn, sometimes no photograph at all."""
    if source.random() < 0.08:
        text = readings(name).encode()
        return source.choice(
            (b"", b"\xff", text, b"\xff\xd8\xff", b"<svg/>", bytes(range(256)) * 9)
        )
    image = _as(source.choice(MODES), picture(source, name, number), source)
    form = source.choice(FORMATS)
    options = {"save_all": True, "append_images": [image, image]} if _moves(source, form) else {}
    if source.random() < 0.1:
        about = Image.Exif()
        about[0x0112] = source.choice((0, 3, 6, 9, 65535))
        options["exif"] = about
    file = io.BytesIO()
    try:
        image.save(file, form, **options)
    except (OSError, ValueError, TypeError, AttributeError):  # that form has no such colours
        file = io.BytesIO()
        image.convert("RGB").save(file, "PNG")
    return _torn(source, file.getvalue()) if source.random() < 0.25 else file.getvalue()


def _moves(source: random.Random, form: str) -> bool:
    return form in ("GIF", "PNG", "TIFF", "WEBP") and source.random() < 0.3


def _as(mode: str, image: Image.Image, source: random.Random) -> Image.Image:
    """Return a grey picture in other colours, deeper, or partly transparent."""
    levels = np.asarray(image)
    if mode == "I;16":
        return Image.fromarray(levels.astype(np.uint16) * 257)
    if mode == "I":
        return Image.fromarray(levels.astype(np.int32) * source.choice((1, 257, -5, 1 << 23)))
    if mode == "F":
        return Image.fromarray(
            levels.astype(np.float32) * source.choice((1.0, 1 / 255, np.nan, 1e36))
        )
    if mode == "LAB":
        return Image.merge("LAB", (image, image, image))
    other = image.convert("RGB" if mode == "YCbCr" else "L").convert(mode)
    if mode in ("RGBA", "LA"):
        other.putalpha(source.choice((0, 1, 128, 255)))
    if mode == "P" and source.random() < 0.5:
        other.info["transparency"] = source.choice((0, 70, 255))
    return other


def _torn(source: random.Random, data: bytes) -> bytes:
    """Return a file cut off, or with other bytes in a few places."""
    if source.random() < 0.5:
        return data[: source.randrange(len(data))]
    torn = bytearray(data)
    for _ in range(source.choice((1, 3, 30))):
        at = min(source.choice((source.randrange(len(torn)), source.randrange(64))), len(torn) - 1)
        torn[at] = source.randrange(256)
    return bytes(torn)


# ---------------------------------------------------------------- the command line


def _place(at: complex) -> str:
    return f"{at.real:.1f},{at.imag:.1f}"


def corners(source: random.Random, right: tuple[complex, ...]) -> str:
    """Return corners as they are typed: right, not quite, or none."""
    several = [_place(z + source.choice((0, 0, 3 - 2j, 40))) for z in right]
    source.shuffle(several)
    if source.random() < 0.4:
        several = [_place(z) for z in right]
    if source.random() < 0.3:
        at, (x, y) = source.randrange(4), (source.choice(NUMBERS) for _ in range(2))
        several[at] = source.choice(
            (f"{x},{y}", f"{several[at].partition(',')[0]},{y}", several[0])
        )
    return source.choice(PLACES) if source.random() < 0.3 else " ".join(several)


def pole(source: random.Random, right: tuple[tuple[str, str, complex], ...]) -> str:
    """Return where a pole is as it is typed: right, of another plan, or anywhere."""
    plan, position, at = source.choice((*right, ("velocities", "1", 100 + 100j)))
    if source.random() < 0.2:
        plan = source.choice(("", "plans", ":", "=", "скорости", "x" * 300, "results"))
    if source.random() < 0.2:
        position = source.choice(("", "0", "99", "1'", ":", "²", "1=1"))
    x, y = (
        source.choice(NUMBERS) if source.random() < 0.35 else f"{z:.1f}" for z in (at.real, at.imag)
    )
    return source.choice((f"{plan}:{position}={x},{y}",) * 9 + (f"{plan}={x}", f"{x},{y}", ""))


def task(seed: int, number: int, names: tuple[str, ...] = ()) -> Task:
    """Return the task of a case, told by the seed and its number alone: one thing is changed, or several."""
    source = random.Random(f"photographs:{seed}:{number}")
    name, sheet = source.choice(names or NAMES), source.choice((1, 2, 2, 3))
    whole, text, given = shown(name, sheet), scenes()[name], None
    wrong = {source.choice(CHANGED) for _ in range(source.choice((1, 1, 1, 2, 4)))}
    line = ["photo", SCENE, PHOTO, "--sheet", str(sheet)]
    line += ["--overlay", f"{OUT}/o.svg", "--trials", "20"]
    if whole.poles and not {"sheet", "scene"} & wrong:  # a sheet without plans has no report
        line += ["-f", "json"]
    if "corners" in wrong:
        line += ["--corners", corners(source, whole.corners)]
    elif source.random() < 0.6:
        line += ["--corners", " ".join(map(_place, whole.corners))]
    for _ in range(source.choice((1, 1, 2)) if "pole" in wrong else 0):
        line += ["--pole", pole(source, whole.poles)]
    if "sheet" in wrong:
        line[4] = source.choice(("1", "2", "3", "0", "4", "99999999999999999999", "-1", "x", "1.0"))
    if "readings" in wrong:
        given = changed_readings(source, name)
        line.insert(3, CSV)
    elif source.random() < 0.4:
        line += ["--readings-out", source.choice(WRITTEN)]
    if "scene" in wrong:
        other = scenes()[source.choice(NAMES)]
        text = source.choice((changed_scene(source, name), other))
    data = photograph(source, name, sheet) if "file" in wrong else _jpeg(whole.image)
    return Task(name, "photograph", text, given, None, tuple(line), data)


def _jpeg(image: Image.Image) -> bytes:
    file = io.BytesIO()
    image.save(file, "JPEG")
    return file.getvalue()


def case(number: int, seed: int = 0, names: tuple[str, ...] = ()) -> Case:
    """Run one case."""
    return cased(number, task(seed, number, names))


if __name__ == "__main__":
    sys.exit(command("Check photographs changed at random.", task, case, 500))
