"""The command `variants`: a seed is a table, which is read back; status 2 where there is none."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import SHEETS

from graphic_tmm.classroom.variants import drawing
from graphic_tmm.classroom.variants.table import read_variants
from graphic_tmm.classroom.variants.variant import base, scene_of

YOKE = SHEETS / "scotch-yoke"


def all_are_good(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every variant be good, and none be drawn."""
    monkeypatch.setattr(drawing, "measure_of", lambda *given: None)
    monkeypatch.setattr(drawing, "refused", lambda *given: "")


@pytest.mark.slow
def test_a_seed_gives_the_same_bytes_and_another_one_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Drawn twice; whatever comes later is taken for good."""
    first, again = (invoke("variants", YOKE, "--count", 2, "--seed", 7) for _ in range(2))
    all_are_good(monkeypatch)
    other = invoke("variants", YOKE, "--count", 2, "--seed", 8)
    assert first.exit_code == other.exit_code == 0, first.output
    assert first.stdout == again.stdout != other.stdout
    assert "из перебранных" in first.stderr
    for name in ("a.csv", "a.xlsx", "b.xlsx"):
        assert not invoke("variants", YOKE, "-n", 2, "--seed", 7, "-o", tmp_path / name).exit_code
    assert (tmp_path / "a.csv").read_text(encoding="utf-8") == first.stdout
    assert (tmp_path / "a.xlsx").read_bytes() == (tmp_path / "b.xlsx").read_bytes()
    found = read_variants(tmp_path / "a.csv")
    assert found == read_variants(tmp_path / "a.xlsx")
    assert [one.name for one in found] == ["01", "02"]
    for one in found:
        assert "Вариант" in scene_of(base(YOKE), one, "a.csv").title


def test_ranges_elsewhere_and_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    all_are_good(monkeypatch)
    file = tmp_path / "own.toml"
    file.write_text('[ranges]\n"link 1, points.A[1]" = ["40 mm", "50 mm"]\n', encoding="utf-8")
    assert invoke("variants", YOKE, "--ranges", file, "-n", 2).exit_code == 0
    table = tmp_path / "v.csv"
    done = invoke("variants", YOKE, "--ranges", file, "-n", 3, "-o", table)
    assert done.exit_code == 2
    assert not table.exists()
    assert invoke("variants", YOKE, "--ranges", tmp_path / "no.toml").exit_code == 2
    assert invoke("variants", YOKE, "-o", tmp_path / "v.txt").exit_code == 2


def test_a_scene_without_ranges_says_which_file_is_missing() -> None:
    done = invoke("variants", SHEETS / "windrower")
    assert done.exit_code == 2
    assert "ranges.toml" in done.stderr


@pytest.mark.parametrize("option", [("--count", "0"), ("--seed", "-1")])
def test_wrong_options_are_refused(option: tuple[str, str]) -> None:
    assert invoke("variants", YOKE, *option).exit_code == 2
