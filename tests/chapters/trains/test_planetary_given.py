"""What is given of a planetary train, as the sheet of the task has it."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.boards import usual_part
from support.gallery import scene
from support.scenes import calling

from graphic_tmm.chapters.trains.record import BESIDE
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.task_sheet import Given, given_rows, given_table
from graphic_tmm.scene.read import read


def test_speed_ratio_module_teeth_and_satellites() -> None:
    rows = {row.symbol: row.value for row in given_rows(scene("planetary"), "planetary")}
    assert rows == {
        **{"n_1": 2888.0, "U_{1H}": 4.55, "ΔU_{max}": pytest.approx(0.3), "m": 8.0},
        **{"z_1": 25, "z_4": 15, "z_5": 25, "k": "3"},
    }
    view = given_table(scene("planetary"), board="planetary")
    assert view.title == "Исходные данные: редуктор"
    texts = {label.text for label in view.labels}
    assert {"Исходные данные:", "редуктор", "2888", "об/мин", "4,55"} <= texts


def test_a_carrier_that_drives_and_two_modules(tmp_path: Path) -> None:
    section = (
        '[planetary]\nscheme = "external-internal"\nmodule = "4 mm"\nmodule_2 = "5 mm"\n'
        'driving = "H"\nspeed = "100 1/s"\nratio = 0.1\ntolerance = 0.05\nsatellites = [3, 4]\n'
    )
    path = calling(tmp_path, section, sheet="", head='title = "T"\n')
    rows = given_rows(read(path), "planetary")
    assert rows == (
        Given("ω_H", 100.0, "1/s"),
        Given("U_{H1}", 0.1),
        Given("ΔU_{max}", 5.0, "%"),
        Given("m_{1-2}", 4.0, "mm"),
        Given("m_{3-4}", 5.0, "mm"),
        Given("k", "3, 4"),
    )


@pytest.mark.parametrize(("speed", "last"), [("-1440 rpm", -216.0), ("1440 rpm", 216.0)])
def test_a_shaft_may_turn_the_other_way(speed: str, last: float, tmp_path: Path) -> None:
    """1440/4 to the carrier, and its pair of 15 and 25 turns it about."""
    section = (
        f'[planetary]\nscheme = "ring"\nmodule = "4 mm"\nspeed = "{speed}"\n'
        'teeth = [24, 24, 72]\nbehind = [15, 25]\n[[sheet]]\nplace = ["planetary"]\n'
    )
    scene = read(calling(tmp_path, section, sheet="", head='title = "T"\n'))
    assert given_rows(scene, "planetary")[0] == Given(
        "n_1", pytest.approx(last / 0.15, rel=1e-9), "rpm"
    )
    drawn = usual_part("planetary", scene)
    turns = BESIDE.on(drawn).turns
    assert drawn.reading[turns["5"]].item() == pytest.approx(-last, rel=1e-9)


def test_a_shaft_that_stands_does_not_drive(tmp_path: Path) -> None:
    section = '[planetary]\nscheme = "ring"\nmodule = "4 mm"\nspeed = 0\nteeth = [24, 24, 72]\n'
    with pytest.raises(SceneError, match=r"the driving shaft turns at 0\.0"):
        read(calling(tmp_path, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
