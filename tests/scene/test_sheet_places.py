"""What stands on a sheet that does not say: all that the scene calls for, but what another sheet names."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.scenes import written

from graphic_tmm.scene.read import read

HEAD = (SHEETS / "crank-rocker" / "scene.toml").read_text("utf-8").partition("[[sheet]]")[0]


@pytest.mark.parametrize(
    ("named", "gone"),
    [
        ('["velocities"]', {"velocities"}),
        ('["velocities", "structure"]', {"velocities", "structure"}),
        ('["velocity table", "acceleration table"]', {"results"}),  # both its parts
        ('["velocity table"]', set()),  # the other part is shown nowhere else
    ],
)
def test_it_leaves_out_what_another_sheet_names(named: str, gone: set[str], tmp_path: Path) -> None:
    alone = read(written(tmp_path, f'{HEAD}[[sheet]]\nformat = "A3"\n')).sheets[0].place
    text = f'{HEAD}[[sheet]]\nformat = "A3"\n[[sheet]]\nformat = "A4"\nplace = {named}\n'
    rest = read(written(tmp_path, text)).sheets[0].place
    assert set(alone) - set(rest) == gone
    assert [place for place in alone if place not in gone] == list(rest)


def test_it_shows_all_where_others_name_all(tmp_path: Path) -> None:
    alone = read(written(tmp_path, f"{HEAD}[[sheet]]\n")).sheets[0].place
    listed = ", ".join(f'"{place}"' for place in alone)
    both = read(written(tmp_path, f"{HEAD}[[sheet]]\n[[sheet]]\nplace = [{listed}]\n")).sheets
    assert both[0].place == both[1].place == alone
