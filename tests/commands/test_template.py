"""template: printed or written, whole or short; what does not go together is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke


def test_a_short_template_is_printed_without_a_picture() -> None:
    done = invoke("template", "slider-diagrams", "--short")
    assert done.exit_code == 0
    assert "velocities;1;pb;;;;;" in done.stdout
    assert "svg" not in done.stdout


@pytest.mark.parametrize("form", ["csv", "xlsx"])
def test_a_template_is_written_with_its_picture_and_read_back(tmp_path: Path, form: str) -> None:
    if form == "xlsx":
        pytest.importorskip("openpyxl")
    file = tmp_path / f"t.{form}"
    done = invoke("template", "slider-diagrams", "--only", "скорости:pb", "-o", file)
    assert done.exit_code == 0
    assert done.stdout.split() == [str(file), str(tmp_path / "t.svg")]
    assert "<svg" in (tmp_path / "t.svg").read_text("utf-8")
    empty = invoke("check", "slider-diagrams", file)
    assert empty.exit_code == 2  # there is nothing to judge
    assert not list(tmp_path.glob("*.part"))


def test_the_whole_template_is_written_too(tmp_path: Path) -> None:
    file = tmp_path / "t.csv"
    assert invoke("template", "slider-diagrams", "-o", file).exit_code == 0
    printed = invoke("template", "slider-diagrams").stdout
    assert file.read_text("utf-8") == printed
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("check", "readings.csv", "--short"), "--short; it is an option of template"),
        (("check", "readings.csv", "-o", "t.csv"), "a report is no table"),
        (("template", "-o", "t.txt"), "name it .csv or .xlsx"),
        (("template", "--only", "rates"), 'what is "rates"'),
        (("template", "--position", "99"), 'what is "99"'),
        (("template", "-o", "/dev/null/t.csv"), "name another file with -o"),
    ],
)
def test_what_cannot_be_asked_for(arguments: tuple[str, ...], says: str) -> None:
    done = invoke(arguments[0], "slider-diagrams", *arguments[1:], "-l", "en")
    assert done.exit_code == 2
    assert says in done.stderr
    assert "Traceback" not in done.stderr


def test_a_template_is_not_written_over_its_scene(tmp_path: Path) -> None:
    scene = tmp_path / "scene.csv"
    source = Path(__file__).parents[2] / "sheets" / "slider-diagrams" / "scene.toml"
    scene.write_bytes(source.read_bytes())
    done = invoke("template", scene, "-o", scene)
    assert done.exit_code == 2
    assert scene.read_bytes() == source.read_bytes()
