"""Small scenes as TOML text, those of the package as text to change, and the file that a scene becomes."""

from __future__ import annotations

from pathlib import Path

from support.gallery import SHEETS


def source(name: str) -> str:
    """Return the text of a scene of the package."""
    return (SHEETS / name / "scene.toml").read_text(encoding="utf-8")


def written(folder: Path, text: str) -> Path:
    """Write a scene into a folder; return its file."""
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


def edited(folder: Path, *edits: tuple[str, str], name: str = "engine") -> Path:
    """Write a scene of the package with texts of it replaced; return its file."""
    text = source(name)
    for old, new in edits:
        assert old in text
        text = text.replace(old, new)
    return written(folder, text)


def slider_crank(
    drive: str,
    *,
    crank: float = 0.1,
    rod: float = 0.35,
    points: str = "",
    of_rod: str = "",
    of_slider: str = "",
    language: str = "en",
) -> str:
    """Return an in-line slider-crank, ``drive`` and what follows it behind; lengths in m.

    ``points``: further ones of the rod; ``of_rod``, ``of_slider``: further keys of these links, a line each.
    """
    return f"""title = "T"
language = "{language}"
[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = 0 }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{crank}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{rod}, 0]{points} }}
{of_rod}[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
{of_slider}[drive]
link = 1
{drive}"""


MECHANISM = slider_crank(
    'speed = "40 1/s"\npositions = 8\n',
    points=', S2 = ["0.12 m", 0]',
    of_rod='mass = "2 kg"\nJ = "0.02 kg*m^2"\ncentre = "S2"\n',
    of_slider='mass = "3 kg"\ncentre = "B"\n',
)
SECTIONS = {
    "effects": "[effects]\ngravity = true\ninertia = true\n",
    "load": '[[load]]\nlink = 3\npoint = "B"\nforce = "120 N"\n',
    "forces": "[forces]\npositions = [1, 2]\n",
    "diagrams": '[diagrams]\npoint = "B"\n',
    "flywheel": '[flywheel]\ndelta = 0.05\nconstant = "driving"\n',
    "indicator": '[indicator]\npoint = "B"\nbore = "0.1 m"\ncover = [1e5, 1e5, 9e4, 8e4, 7e4, 6e4, 5e4, 4e4]\n',
    "engine": '[engine]\npoint = "B"\n',
    "cam": '[cam]\nstroke = "20 mm"\nrise = 90\nfall = 100\n',
    "gears": '[gears]\nz1 = 21\nz2 = 34\nm = "5 mm"\n',
    "planetary": '[planetary]\nmodule = "4 mm"\nspeed = "100 1/s"\nratio = 4.6\n',
    "friction": "[friction]\nf = 0.1\n",
}
ONLY_POSITIONS = '[[sheet]]\nplace = ["positions"]\n'


def calling(
    folder: Path, *sections: str, sheet: str = ONLY_POSITIONS, head: str = MECHANISM
) -> Path:
    """Write a scene that calls for sections, by their names or as text; return its file."""
    return written(folder, head + "".join(SECTIONS.get(k, k) for k in sections) + sheet)
