"""A scene whose words are given: of its title, its links, its title block."""

from __future__ import annotations

import re
from pathlib import Path

from support.scenes import written

SCENE = """title = {title}
language = "{language}"
[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = "0 deg" }}
[[link]]
number = 1
name = {name}
points = {{ O = [0, 0], A = ["0.3 m", 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = ["0.64 m", 0] }}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
[drive]
link = 1
speed = {speed}
positions = 4
[[sheet]]
format = "{format}"
place = ["positions", "structure"]
[title_block]
{block}
"""
BLOCK = (
    *("designation", "name", "organisation", "drawn_by", "checked_by", "standards_by"),
    *("approved_by", "material", "letter", "mass", "scale"),
)


def quoted(text: str) -> str:
    """Return a text as TOML writes it."""
    body = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + re.sub("[\x00-\x1f\x7f]", lambda m: f"\\u{ord(m[0]):04X}", body) + '"'


def worded(folder: Path, format: str = "A4", language: str = "ru", **texts: str) -> Path:
    """Write a slider-crank whose texts are given; return its file."""
    block = "\n".join(f"{k} = {quoted(texts[k])}" for k in BLOCK if k in texts and k != "name")
    known = {"title": "T", "name": "n", "speed": "50 1/s"} | texts
    words = {key: quoted(known[key]) for key in ("title", "name", "speed")}
    return written(folder, SCENE.format(format=format, language=language, block=block, **words))
