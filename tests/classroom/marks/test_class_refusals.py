"""mark with wrong input: one message, status 2, nothing written; names that are hostile."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest
from support.command import invoke
from support.each import each
from support.handed_in import hand_in, variant_text

EVIL = '=cmd|" <script>alert(1)<_script> \x1b[31m'


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    file = tmp_path / "slider.toml"
    file.write_text(variant_text(1, 6), "utf-8")
    (tmp_path / "handed").mkdir()
    (tmp_path / "handed" / "01.csv").write_text("plan,position,segment,mm\n", "utf-8")
    return file


WRONG = {
    "no folder": ("mark", "none"),
    "empty folder": ("mark", "empty"),
    "no table": ("mark", "handed", "--variants", "none.csv"),
    "bad table": ("mark", "handed", "--variants", "bad.csv"),
    "bad variant": ("mark", "handed", "--variants", "variant.csv"),
    "no rule": ("mark", "handed", "--marks", "none.toml"),
    "bad rule": ("mark", "handed", "--marks", "bad.toml"),
    "readings too": ("mark", "handed", "handed/01.csv"),
    "of one": ("mark", "handed", "--overlay", "o.svg"),
    "no class": ("check", "handed/01.csv", "--variants", "variant.csv"),
    "json": ("mark", "handed", "-f", "json"),
    "xlsx to nowhere": ("mark", "handed", "-f", "xlsx"),
    "out among them": ("mark", "handed", "-o", "handed/out"),
    "csv of one": ("check", "handed/01.csv", "-f", "csv"),
}


@each("name", WRONG)
@pytest.mark.slow
def test_wrong_input_is_told_and_nothing_written(
    scene: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(scene.parent)
    Path("empty").mkdir(exist_ok=True)
    Path("bad.csv").write_text("variant\n", "utf-8")
    Path("variant.csv").write_text("variant,wheel\n01,5\n", "utf-8")
    Path("bad.toml").write_text("[points]\nwrong = -3\n", "utf-8")
    before = sorted(scene.parent.rglob("*"))
    command, *words = WRONG[name]
    if "-o" not in words and name not in ("xlsx to nowhere", "no class", "csv of one"):
        words += ["-o", "out"]
    done = invoke(command, scene, *words)
    assert done.exit_code == 2, done.output
    assert done.stderr.strip()
    assert "Traceback" not in done.output
    assert sorted(scene.parent.rglob("*")) == before


@pytest.mark.slow
def test_hostile_names_do_nothing(scene: Path) -> None:
    place = scene.parent / "handed"
    (place / "01.csv").unlink()
    (place / f"{EVIL} 1.csv").write_text(hand_in(1, 5, positions=6, mode="mm").text, "utf-8")
    (place / f"@{EVIL}.csv").write_text("", "utf-8")
    out = scene.parent / "out"
    done = invoke("mark", scene, place, "--trials", 40, "-o", out)
    assert done.exit_code == 1, done.output
    assert "\x1b" not in done.output
    for name in ("summary.csv", "gradebook.csv"):
        rows = list(csv.reader(io.StringIO((out / name).read_text("utf-8"), newline="")))
        assert not [cell for row in rows for cell in row if cell.startswith(("=", "@"))]
        assert any(cell.startswith("'=") for row in rows for cell in row)
    page = (out / "summary.html").read_text("utf-8")
    assert "<script>alert" not in page
    assert "\x1b" not in page
    assert [path.suffix for path in (out / "reports").iterdir()].count(".html") == 1
