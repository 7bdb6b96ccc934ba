"""What a plan refuses after a scene was read is told as the reader tells faults: file, line, key, remedy."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphic_tmm.__main__ import main
from graphic_tmm.errors import StructureError
from graphic_tmm.scene.read import read

SHEETS = Path(__file__).parents[2] / "sheets"
POINTS = "law_points = [[0, 1], [0.5, 1], [0.5, 2], [0.5005, 2], [0.5005, -1], [1, -1]]"
CASES = [
    # scene, what is replaced, by what, key, words that begin its line, words of the message
    ("windrower", "positions = [8]", "positions = [8, 40]", "forces.positions", "", "position 40"),
    ("windrower", 'at = "left"', 'at = "top"', "drive.zero", "zero", "moves neither up nor down"),
    ("windrower", '["other extreme"]', '["9 deg", "9 deg"]', "drive.extra", "extra", "twice"),
    ("windrower", '"D"                       #', '"C" #', "diagrams.point", "point", "not slide"),
    ("windrower", '"0.6 m"', '"60 m"', "flywheel.D_e", "D_e", "runs faster"),
    ("windrower", ', side = "-" }', " }", "link 2, slides", "slides", "assembled in two ways"),
    ("windrower", 'force = "190 N"', 'of = "C"\nout = [[0, 1], [1, 2]]',
     "load 1, of", "of", "C does not slide"),
    ("windrower", "link          = 1", "link = 4", "link 4, drive.link", "[[link]]", "must turn about one"),
    ("crank-rocker", 'side   =', 'flips_at = ["12 deg"]\nside   =',
     "link 2, flips_at, link 2, side", "flips_at", "do not meet there"),
    ("crank-rocker", "of AC", "of BC", "link 2, side", "side", "side speaks of BC"),
    ("crank-rocker", '"60 mm", "-10 mm"', '"600 mm", 0', "link 2, link 3", "[[link]]", "never assembles"),
    ("gear-pair", "x1 = 0.83", "x1 = -3", "gears.x1", "x1", "no working angle"),
    ("cam", "[cam]", '[cam]\noffset = "90 mm"', "cam.offset, cam.r0", "offset", "not less than r0"),
    ("cam", 'law          = "sine"', f'law = "diagram"\n{POINTS}',
     "cam.law_points", "law_points", "no division into 12"),
    ("planetary", "ratio      = 4.55", "ratio = 90", "planetary.ratio, planetary.teeth", "ratio", ""),
]  # fmt: skip


def _written(folder: Path, name: str, old: str, new: str) -> Path:
    text = (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
    assert text.count(old) >= 1, old
    path = folder / "scene.toml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    return path


@pytest.mark.parametrize(("name", "old", "new", "key", "begins", "says"), CASES)
def test_a_refusal_tells_file_line_key_and_remedy(
    name: str, old: str, new: str, key: str, begins: str, says: str, tmp_path: Path
) -> None:
    path = _written(tmp_path, name, old, new)
    done = CliRunner().invoke(main, ["table", str(path), "-l", "en"])
    assert done.exit_code == 2
    told = re.fullmatch(rf"graphic-tmm: {re.escape(str(path))}:(\d+): (.+?): (.+)\n", done.stderr)
    assert told, done.stderr
    assert told[2] == key
    line = path.read_text(encoding="utf-8").splitlines()[int(told[1]) - 1]
    assert line.startswith(begins or old.split()[0]), line
    assert re.search(says, told[3])


def test_what_no_key_says_is_told_with_its_file_alone() -> None:
    scene = read(SHEETS / "engine")
    told = str(scene.located(StructureError("it cannot be")))
    assert told == f"{scene.source}: it cannot be"


def test_a_key_that_is_left_out_is_told_at_its_section() -> None:
    scene = read(SHEETS / "engine")
    text = Path(scene.source).read_text(encoding="utf-8").splitlines()
    (told,) = str(
        scene.located(StructureError("too small", "flywheel.studs", head="flywheel"))
    ).split("\n")
    assert told == f"{scene.source}:{text.index('[flywheel]') + 1}: flywheel.studs: too small"
