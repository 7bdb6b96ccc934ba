"""How finely figures were meant: noughts that were left out, as spreadsheets take them away."""

from __future__ import annotations

from pathlib import Path

import pytest

from graphic_tmm.checking.readings.read import read_readings

HEAD = "plan,position,segment,mm,value,unit,x,y\n"


@pytest.mark.parametrize(
    ("written", "halves"),
    [
        (["1.762", "2", "0.35"], [0.0005, 0.0005, 0.0005]),  # 2.000 and 0.350
        (["78.4", "245", "373"], [0.05, 0.5, 0.5]),  # three digits each
        (["54.5", "54", "5"], [0.05, 0.05, 0.05]),  # a ruler of half a mm
        (["2"], [0.5]),
        (["0", "12.5"], [0.05, 0.05]),
        (["0.2", "5", "0"], [0.05, 0.5, 0.5]),  # one digit each
    ],
)
def test_noughts_that_were_left_out_were_meant(
    written: list[str], halves: list[float], tmp_path: Path
) -> None:
    rows = "".join(f"v,{k},pb,,{figure},m/s,,\n" for k, figure in enumerate(written))
    path = tmp_path / "r.csv"
    path.write_text(HEAD + rows, "utf-8")
    assert [one.last.value for one in read_readings(path)] == pytest.approx(halves, rel=1e-9)
