"""--limit: a time as in scenes; what is none, or would not hold, is refused before anything is done."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke
from support.each import each

from graphic_tmm.commands.shared.options import Time


@each("case", [("90", 90.0), ("90 s", 90.0), ("1,5 мин", 90.0), ("10 min", 600.0), (" .5 ", 0.5)])
def test_times(case: tuple[str, float]) -> None:
    assert Time().convert(case[0], None, None) == pytest.approx(case[1])


@each("text", ["0", "-3 s", "soon", "3 kg", "1e9 min", "nan", "", "0.01 s"])
def test_what_is_no_limit(text: str, tmp_path: Path) -> None:
    done = invoke("batch", "shaper", tmp_path / "none.csv", f"--limit={text}")
    assert done.exit_code == 2
    assert "--limit" in done.stderr
    assert "Traceback" not in done.stderr


def test_where_it_does_not_hold(tmp_path: Path) -> None:
    done = invoke("task", "shaper", "-j", "0", "--limit", "1 min", "-o", tmp_path / "out")
    assert done.exit_code == 2
    assert "--limit" in done.stderr
    done = invoke("check", "shaper", "some.csv", "--limit", "1 min")
    assert done.exit_code == 2
    assert "mark" in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_what_takes_longer_is_told(tmp_path: Path) -> None:
    """No sheet is drawn in a tenth of a second by a process that has just begun."""
    table = tmp_path / "class.csv"
    table.write_text("variant,drive.speed\n1,60 rpm\n", "utf-8")
    done = invoke(
        "batch", "windrower", table, "-l", "en", "-o", tmp_path / "out", "--limit", "0.1 s"
    )
    assert done.exit_code == 1
    assert "0.1 s" in done.stderr
    assert "--limit" in done.stderr
