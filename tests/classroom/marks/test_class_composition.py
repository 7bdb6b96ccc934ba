"""How large plans are drawn: by the composition beside a scene, alone and in a class alike."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from support.command import invoke, printed
from support.handed_in import scene_text, variant_text

POSITIONS = 6
FILLED = (
    "plan,position,segment,mm\nvelocities,1,ab,40\nvelocities,1,pb,30\naccelerations,1,tab,20\n"
)


def unscaled(text: str) -> str:
    """Return a scene without the scale factors that it fixes."""
    before, rest = text.split("[scales]")
    return before + rest[rest.index("[hand]") :]


@pytest.mark.slow
def test_a_class_is_judged_by_the_composition_that_check_takes(tmp_path: Path) -> None:
    (tmp_path / "slider.toml").write_text(unscaled(scene_text(POSITIONS)), "utf-8")
    (tmp_path / "variants.csv").write_text('variant,"OA, mm","AB, mm"\n03,86,345\n', "utf-8")
    place = tmp_path / "handed"
    place.mkdir()
    (place / "03.csv").write_text(FILLED, "utf-8")
    single = tmp_path / "slider-03.toml"
    single.write_text(unscaled(variant_text(3, POSITIONS)), "utf-8")

    def both() -> tuple[str, str]:
        folder = (place, "--variants", tmp_path / "variants.csv", "--trials", 20)
        printed("mark", tmp_path / "slider.toml", *folder, "-o", tmp_path / "out")
        alone = invoke("check", single, place / "03.csv", "--trials", 20, "-f", "json").stdout
        return (tmp_path / "out" / "reports" / "03.json").read_text("utf-8"), alone

    printed("batch", tmp_path / "slider.toml", tmp_path / "variants.csv", "--make", "scene",
            "-o", tmp_path / "keys")  # fmt: skip
    own = tmp_path / "slider-03.composition.toml"
    shutil.copy(tmp_path / "keys" / "03" / "composition.toml", own)
    _, alone = both()
    own.unlink()
    first, _ = both()
    assert first == alone
    printed("draw", tmp_path / "slider.toml", "--composition", "-o", tmp_path / "drawn")
    beside = tmp_path / "slider.composition.toml"
    text = (tmp_path / "drawn" / beside.name).read_text("utf-8")
    smaller, count = re.subn(r'"velocities" = .*', '"velocities" = 30.0', text)
    assert count == 1
    beside.write_text(smaller, "utf-8")
    shutil.copy(beside, own)
    second, alone = both()
    assert second == alone
    assert dues(second) != dues(first)
    # that of the variant itself goes before that of the scene
    beside.write_text(text, "utf-8")
    assert both() == (second, alone)


def dues(report: str) -> list[float]:
    return [one["due_mm"] for one in json.loads(report)["readings"]]
