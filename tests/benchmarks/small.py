"""What a single drawing costs: a dozen positions, an import, a cold start, a whole project."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from clock import ROOT, Row, in_turns, process, show
from support.boards import drawn_of

from graphic_tmm.board.execute import prepare
from graphic_tmm.board.hand import Hand
from graphic_tmm.scene.read import read

PROJECT = ("windrower", "cam", "gear-pair", "planetary")
"""The scenes of the windrower's project, all on A1 sheets."""
LIBRARIES = "import numpy, shapely, svgwrite, click"
NAMES = "from graphic_tmm import *"


def closed_form(phi: np.ndarray) -> np.ndarray:
    """The windrower's positions, velocities and accelerations in bare numpy."""
    oa, ob, bc, omega = 0.13657, 0.48, 0.16694, 39.79
    a = oa * np.exp(1j * phi)
    z = a + 1j * ob
    u, d = z / np.abs(z), np.abs(z)
    v = 1j * omega * a
    w = (v * u.conj()).imag / d
    rel = (v * u.conj()).real
    eps = ((-(omega**2) * a * u.conj()).imag - 2 * w * rel) / d
    c = -1j * ob - bc * u
    vc, ac = 1j * w * (c + 1j * ob), (1j * eps - w**2) * (c + 1j * ob)
    y = -ob - 1.25 * bc
    dx = np.sqrt(bc**2 - (y - c.imag) ** 2)
    r = dx + 1j * (y - c.imag)
    w4 = -vc.imag / r.real
    e4 = (-ac.imag + w4**2 * r.imag) / r.real
    return np.concatenate([vc + 1j * w4 * r, ac + (1j * e4 - w4**2) * r])


def warm() -> list[Row]:
    """Return the lines of a dozen positions: all steps of the three plans, everything kept."""
    made = drawn_of(
        read(ROOT / "sheets" / "windrower").asking(diagrams=None, flywheel=None, forces=None)
    )
    log = made.project.construction
    program, count = prepare(log), len(log.steps)
    phi = np.radians(np.arange(13) * 30.0)
    seconds = in_turns(
        {
            "bare": partial(closed_form, phi),
            "exact": partial(program.run, made.given),
            "read": partial(program.run, made.given, hand=Hand(ruler=0.1)),
        },
        rounds=21,
        least=20,
    )
    ms = {name: f"{each * 1e3:.2f} ms" for name, each in seconds.items()}
    limit = "< 1 ms"
    what = f"windrower, {len(made.project.names)} positions, three plans, {count} steps"
    return [
        Row(f"{what}, executed", ms["exact"], limit, seconds["exact"] < 1e-3),
        Row("the same with readings", ms["read"], limit, seconds["read"] < 1e-3),
        Row("of it, one step", f"{seconds['read'] / count * 1e6:.1f} µs"),
        Row("the same kinematics in closed form, numpy", ms["bare"]),
    ]


def cold() -> list[Row]:
    """Return the lines of fresh processes, down to a drawn project."""
    with TemporaryDirectory() as out:
        both = (
            "from pathlib import Path; from graphic_tmm.scene.read import read;"
            "from graphic_tmm.studio import sheet_files; from graphic_tmm.files import write;"
            f"[write(Path({out!r}) / name, sheet_files(read(Path('sheets') / name))[1])"
            f" for name in {PROJECT!r}]"
        )
        composed = str(Path(out) / "composed")
        shutil.copytree(ROOT / "sheets" / "windrower", composed)
        process("-m", "graphic_tmm", "draw", "-o", composed, "--composition")()
        calls: dict[str, Callable[[], object]] = {
            "pass": process("-c", "pass"),
            "libraries": process("-c", LIBRARIES),
            "import": process("-c", "import graphic_tmm"),
            "names": process("-c", NAMES),
            "help": process("-m", "graphic_tmm", "--help"),
            "draw": process("-m", "graphic_tmm", "draw", "-o", out),
            "searched": process("-m", "graphic_tmm", "table"),
            "table": process("-m", "graphic_tmm", "table", composed),
            "steps": process("-m", "graphic_tmm", "steps", composed),
            "composed": process("-m", "graphic_tmm", "draw", composed, "-o", out),
            "project": process("-c", both),
        }
        seconds = in_turns(calls, rounds=5)

    def line(what: str, name: str, limit: float) -> Row:
        return Row(what, f"{seconds[name]:.2f} s", f"< {limit} s", seconds[name] < limit)

    return [
        Row("python -c pass", f"{seconds['pass']:.2f} s"),
        Row(f"python -c '{LIBRARIES}'", f"{seconds['libraries']:.2f} s"),
        line("python -c 'import graphic_tmm'", "import", 0.2),
        Row(f"python -c '{NAMES}' (every public name)", f"{seconds['names']:.2f} s"),
        Row("graphic-tmm --help", f"{seconds['help']:.2f} s"),
        line("graphic-tmm draw (the default scene, three A1 sheets), cold", "draw", 1.5),
        line("graphic-tmm draw, the same from its composition", "composed", 0.9),
        line("graphic-tmm table, the same; sizes are searched", "searched", 0.45),
        line("graphic-tmm table, from its composition", "table", 0.45),
        line("graphic-tmm steps, from its composition", "steps", 0.45),
        line(f"{', '.join(PROJECT)}: all A1 sheets, one cold process", "project", 4.0),
    ]


def main() -> None:
    """Print the tables."""
    show("12 positions, warm", warm())
    show("fresh processes", cold())


if __name__ == "__main__":
    main()
