"""The guides to a class are true: their commands run in turn, with what students hand in.

Of fewer variants than they say; who hands in fills his table with what the key tells, and one of them errs.
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import SHEETS
from support.guides import LANGUAGES, blocks, commands, filled, guide

from graphic_tmm.classroom.marks.rule_file import read_rule
from graphic_tmm.classroom.variants.ranges import read_ranges
from graphic_tmm.classroom.variants.table import read_variants
from graphic_tmm.classroom.variants.variant import base, scene_of

COUNT = "4"


def handed_in(names: list[str]) -> None:
    """Fill in the table of each variant but the last, from its key; the second lays πd off half as long."""
    Path("handed").mkdir()
    for k, name in enumerate(names[:-1]):
        (table,) = Path("out/tasks").glob(f"{name}-*.csv")
        (key,) = Path("out/keys", name).glob("*.csv")
        into = Path("handed", f"{name} Иванов.csv")
        filled(table, key, into)
        if k == 1:
            rows = into.read_text("utf-8").splitlines()
            into.write_text("\n".join(map(_halved, rows)), "utf-8")


def _halved(row: str) -> str:
    cells = row.split(";" if ";" in row else ",")
    if "πd" not in cells:
        return row
    cells[3] = f"{float(cells[3].replace(',', '.')) / 2:.1f}"
    return (";" if ";" in row else ",").join(
        cell.replace(".", ",") if ";" in row else cell for cell in cells
    )


@pytest.mark.slow
def test_every_command_of_the_guide_does_what_it_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, many: Callable[[int, int], int]
) -> None:
    """In one language, as the other tells the same commands and rule; in both when measured."""
    for language in LANGUAGES if many(1, 0) else ("ru",):
        (folder := tmp_path / language).mkdir()
        monkeypatch.chdir(folder)
        monkeypatch.setenv("LC_ALL", language)
        _followed(language)


def _followed(language: str) -> None:
    text = guide("class", language)
    Path("marks.toml").write_text(blocks(text)[-1], "utf-8")
    for words in commands(text):
        given = [COUNT if word == "30" else word for word in words]
        if words[0] == "mark":
            handed_in([one.name for one in read_variants(Path("class.csv"))])
        done = invoke(*given)
        assert done.exit_code == 0, (words, done.output)
    variants = read_variants(Path("class.csv"))
    assert len(variants) == int(COUNT)
    assert len(list(Path("out/tasks").glob("*.svg"))) == int(COUNT)
    _, *rows = csv.reader(Path("marked/summary.csv").read_text("utf-8-sig").splitlines())
    points = [float(row[3]) for row in rows]
    assert len(points) == int(COUNT) - 1
    assert points[1] < min(points[0], points[2]), rows
    assert min(points[0], points[2]) >= 90
    assert len(list(Path("marked/reports").glob("*.html"))) == int(COUNT) - 1
    assert {path.name for path in Path("all").iterdir() if path.is_dir()} >= {
        one.name for one in variants
    }


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_the_guide_shows_can_be_read(language: str, tmp_path: Path) -> None:
    text, of = guide("class", language), base(SHEETS / "shaper")
    (tmp_path / "ranges.toml").write_text(blocks(text)[0], "utf-8")
    (tmp_path / "marks.toml").write_text(blocks(text)[-1], "utf-8")
    (tmp_path / "class.csv").write_text(blocks(text, "csv")[0], "utf-8")
    assert len(read_ranges(tmp_path / "ranges.toml", of).ranges) == 2
    assert read_rule(tmp_path / "marks.toml").scale == 100
    for one in read_variants(tmp_path / "class.csv"):
        assert scene_of(of, one).title.endswith(one.name)


def test_the_guides_tell_the_same() -> None:
    first, second = (commands(guide("class", language)) for language in LANGUAGES)
    assert first == second
    assert len({blocks(guide("class", language))[-1] for language in LANGUAGES}) == 1
    assert guide("class", "en").count("\n## ") == guide("class", "ru").count("\n## ")


READY = sorted(file.parent.name for file in SHEETS.glob("*/ranges.toml"))


@pytest.mark.parametrize("name", READY)
def test_scenes_with_ranges_are_called_ready_and_can_be_measured(name: str) -> None:
    for language in LANGUAGES:
        assert f"`{name}`" in guide("class", language)
    found = read_ranges(SHEETS / name / "ranges.toml", base(SHEETS / name))
    assert found.ranges
    assert found.good.vector >= 3.0
