"""The section [diagrams]: what it says, what it may not say."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS

from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.chapters.diagrams.task import KinematicTask
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

ENGINE = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")


def scene(folder: Path, *lines: str, text: str = ENGINE) -> Scene:
    file = folder / "scene.toml"
    section = "\n".join(("[diagrams]", *lines)) + "\n\n[plans]"
    file.write_text(text.replace("[plans]", section, 1), encoding="utf-8")
    return read(file)


def test_what_is_left_out_has_its_usual_value(tmp_path: Path) -> None:
    assert scene(tmp_path, 'point = "B"').tasks["diagrams"] == KinematicTask("B")


def test_every_key_arrives_in_mm_and_si(tmp_path: Path) -> None:
    made = scene(
        tmp_path,
        'point = "B"', 'start = "velocity"', 'method = "касательные"', 'mu_t = "2.5e-3 s/mm"',
        'mu_V = "0.075 (m/s)/mm"', 'H_a = "15 mm"', 'H_S = "2 cm"',
    ).tasks["diagrams"]  # fmt: skip
    assert made == KinematicTask(
        "B",
        "velocity",
        "time",
        "tangents",
        None,
        0.0025,
        ScaleOrder(None, 20.0),
        ScaleOrder(0.075),
        ScaleOrder(None, 15.0),
    )
    over = scene(tmp_path, 'point = "B"', 'over = "angle"', 'mu_phi = "0.05 rad/mm"').tasks[
        "diagrams"
    ]
    assert over is not None
    assert (over.over, over.mu_along) == ("angle", 0.05)


@pytest.mark.parametrize(
    ("lines", "key", "says"),
    [
        ([], "diagrams.point", 'write for example point = "D"'),
        (['point = "Q"'], "diagrams.point", "points of moving links are"),
        (['point = "b"'], "diagrams.point", 'did you mean "B"'),
        (['point = "B"', 'start = "acceleration"'], "diagrams.start", '"displacement"'),
        (['point = "B"', 'method = "chord"'], "diagrams.method", 'did you mean "chords"'),
        (['point = "B"', 'base = "1 m"', 'mu_t = "0.001 s/mm"'], "diagrams.mu_t", "base fixes"),
        (['point = "B"', 'mu_phi = "0.05 rad/mm"'], "diagrams.mu_phi", 'or over = "angle"'),
        (['point = "B"', 'over = "angle"', 'mu_t = "1 s/mm"'], "diagrams.mu_t", 'over = "time"'),
        (['point = "B"', 'mu_V = "1 (m/s)/mm"', 'H_V = "9 mm"'], "diagrams.H_V", "same scale"),
        (['point = "B"', 'H_S = "20 mm"'], "diagrams.H_S", "it has no pole"),
        (['point = "B"', 'start = "velocity"', 'H_V = "20 mm"'], "diagrams.H_V", "write mu_V"),
        (['point = "B"', 'H_V = "0 mm"'], "diagrams.H_V", "60 mm"),
        (['point = "B"', 'integral = "none"'], "diagrams.integral", "laid off, not integrated"),
        (
            ['point = "B"', 'start = "velocity"', 'integral = "none"', 'H_S = "20 mm"'],
            "diagrams.H_S",
            "nothing is integrated",
        ),
        (['point = "B"', 'H_V = "-5 mm"'], "diagrams.H_V", "60 mm"),
        (['point = "B"', 'mu_t = "0.1 m/mm"'], "diagrams.mu_t", "s/mm"),
        (['point = "B"', "H = 20"], "diagrams.H", "H_S"),
    ],
)
def test_what_cannot_be_meant_is_told_with_a_remedy(
    tmp_path: Path, lines: list[str], key: str, says: str
) -> None:
    with pytest.raises(SceneError) as refused:
        scene(tmp_path, *lines)
    told = [(fault.key, fault.message) for fault in refused.value.faults]
    assert [found for found, _ in told] == [key]
    assert says in told[0][1]


def test_diagrams_need_four_positions(tmp_path: Path) -> None:
    few = ENGINE.replace("positions     = 12", "positions     = 3").replace("[2, 5]", "[2]")
    with pytest.raises(SceneError, match=r"4 positions at least, there are 3"):
        scene(tmp_path, 'point = "B"', text=few)


def test_diagrams_that_are_placed_have_to_be_asked_for(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    text = ENGINE.replace('place  = ["positions", "velocities", "flywheel"', 'place = ["diagrams"')
    file.write_text(text, encoding="utf-8")
    with pytest.raises(SceneError, match=r"write a section \[diagrams\]"):
        read(file)
