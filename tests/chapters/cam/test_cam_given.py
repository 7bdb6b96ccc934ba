"""What is given of a cam stands beside its profile, as the sheet of the task has it."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import paper, scene
from support.scenes import written

from graphic_tmm.chapters.cam.views import cam_views
from graphic_tmm.readers.task_sheet import given_rows, given_table
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

HEAD = 'title = "T"\n[cam]\nrise = 100\nupper_dwell = 20\nfall = 90\n'


def told(folder: Path, text: str) -> dict[str, tuple[object, str]]:
    rows = given_rows(read(written(folder, HEAD + text)), "cam")
    return {row.symbol: (row.value, row.unit) for row in rows}


def test_a_roller_by_phases_law_and_pressure_angle(tmp_path: Path) -> None:
    assert told(tmp_path, 'stroke = "28 mm"\noffset = "6 mm"\ntransmission = 55\n') == {
        "h": (pytest.approx(28.0), "mm"),
        **{"φ_1": (100.0, "°"), "φ_2": (20.0, "°"), "φ_3": (90.0, "°"), "φ_4": (150.0, "°")},
        "given law": ("law sine", ""),
        "e": (pytest.approx(6.0), "mm"),
        "[α]": (35.0, "°"),
    }


def test_a_rocker_swings_and_a_flat_face_has_a_least_radius(tmp_path: Path) -> None:
    text = 'stroke = "20 deg"\nfollower = "rocker"\nlever = "0.1 m"\ncentres = "0.13 m"\n'
    found = told(tmp_path, text + 'law = "cosine"\nreturn_law = "3-4-5"\npressure_return = 60\n')
    assert (found["β"], found["[α_f]"]) == ((pytest.approx(20.0), "°"), (60.0, "°"))
    assert (found["l"][0], found["a_w"][0]) == (pytest.approx(100.0), pytest.approx(130.0))
    assert found["given law of the rise"] == ("law cosine", "")
    assert found["given law of the return"] == ("law 3-4-5", "")
    found = told(tmp_path, 'stroke = "20 mm"\nfollower = "flat"\nleast_curvature = "5 mm"\n')
    assert found["[ρ]"] == (pytest.approx(5.0), "mm")
    assert "[α]" not in found


@pytest.mark.slow
def test_the_diagrams_of_a_rocker_are_those_of_its_angle(tmp_path: Path) -> None:
    """Axes, titles, scale factors and the table say ψ, of a roller on a rod S."""
    rocker = 'stroke = "20 deg"\nfollower = "rocker"\nlever = "0.1 m"\ncentres = "0.13 m"\n'
    for text, own, other in ((rocker, "ψ", "S"), ('stroke = "28 mm"\n', "S", "ψ")):
        sheet = '[[sheet]]\nformat = "A1"\nplace = ["cam"]\n'
        (part,) = make(read(written(tmp_path, HEAD + text + sheet))).boards
        views = cam_views(part, True)
        lettered = {label.text.partition(",")[0] for view in views for label in view.labels}
        assert {own, f"{own}′", f"{own}″"} <= lettered
        assert not {other, f"{other}′", f"{other}″"} & lettered
        scales = [label for label in lettered if label.startswith("μ_")]
        assert any(f"μ_{own}" in label or f"μ_{{{own}" in label for label in scales)
        assert not any(f"μ_{other}" in label or f"μ_{{{other}" in label for label in scales)


def test_it_is_told_in_russian_and_stands_on_the_sheet_of_the_cam() -> None:
    texts = {label.text for label in given_table(scene("cam"), board="cam").labels}
    assert {
        "Исходные данные:",
        "кулачок",
        "Закон движения",
        "синусоидальный",
        "φ_4",
        "150",
    } <= texts
    _, papers = paper("cam")
    assert [v.name for s in papers for v in s.drawings].count("table-given-cam") == 1
