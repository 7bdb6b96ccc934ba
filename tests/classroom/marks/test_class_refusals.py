"""check --class with wrong input: one message, status 2, nothing written; names that are hostile."""

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
    "no folder": ("--class", "none"),
    "empty folder": ("--class", "empty"),
    "no table": ("--class", "handed", "--variants", "none.csv"),
    "bad table": ("--class", "handed", "--variants", "bad.csv"),
    "bad variant": ("--class", "handed", "--variants", "variant.csv"),
    "no rule": ("--class", "handed", "--marks", "none.toml"),
    "bad rule": ("--class", "handed", "--marks", "bad.toml"),
    "readings too": ("handed/01.csv", "--class", "handed"),
    "template too": ("--template", "--class", "handed"),
    "no class": ("handed/01.csv", "--variants", "variant.csv"),
    "json": ("--class", "handed", "-f", "json"),
    "xlsx to nowhere": ("--class", "handed", "-f", "xlsx"),
    "out among them": ("--class", "handed", "-o", "handed/out"),
    "csv of one": ("handed/01.csv", "-f", "csv"),
}


@each("name", WRONG)
def test_wrong_input_is_told_and_nothing_written(
    scene: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(scene.parent)
    Path("empty").mkdir(exist_ok=True)
    Path("bad.csv").write_text("variant\n", "utf-8")
    Path("variant.csv").write_text("variant,wheel\n01,5\n", "utf-8")
    Path("bad.toml").write_text("[points]\nwrong = -3\n", "utf-8")
    before = sorted(scene.parent.rglob("*"))
    done = invoke("check", scene, *WRONG[name], *(() if "-o" in WRONG[name] else ("-o", "out"))) if (
        name not in ("xlsx to nowhere", "no class", "csv of one")
    ) else invoke("check", scene, *WRONG[name])  # fmt: skip
    assert done.exit_code == 2, done.output
    assert done.stderr.strip()
    assert "Traceback" not in done.output
    assert sorted(scene.parent.rglob("*")) == before


def test_hostile_names_do_nothing(scene: Path) -> None:
    place = scene.parent / "handed"
    (place / "01.csv").unlink()
    (place / f"{EVIL} 1.csv").write_text(hand_in(1, 5, positions=6, mode="mm").text, "utf-8")
    (place / f"@{EVIL}.csv").write_text("", "utf-8")
    out = scene.parent / "out"
    done = invoke("check", scene, "--class", place, "--trials", 40, "-o", out)
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
