"""mark on a class drawn without the package: rows, marks, files, statuses."""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
from collections import Counter
from collections.abc import Callable
from decimal import Decimal
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from typing import Any, NamedTuple

import pytest
from click.testing import Result
from openpyxl import load_workbook
from support.command import invoke
from support.handed_in import SCENE, hand_in, variant_text, write_class, wrong_link

POSITIONS, COUNT = 8, 7
TRIALS = ("--trials", 40)


class Handed(NamedTuple):
    """A class as it was marked: its folder, what the command printed, the rows of its summary by name."""

    folder: Path
    done: Result
    rows: dict[str, dict[str, str]]


@cache
def marked() -> Handed:
    """Mark a class: mistakes, a copy, readings of another variant, files that cannot be read."""
    folder = Path(mkdtemp())
    handed = write_class(folder, COUNT, positions=POSITIONS)
    (handed / "02.csv").rename(handed / "Иванов-02.csv")
    shutil.copy(handed / "01.csv", handed / "Petrov 01.csv")
    far = hand_in(15, 99, positions=POSITIONS)  # OA and AB are far from those of variant 08
    (folder / "variants.csv").write_text(
        (folder / "variants.csv").read_text("utf-8") + "08,80,370\n15,110,360\n", "utf-8"
    )
    (handed / "Sidorov 08.csv").write_text(far.text, "utf-8")
    (handed / "corrupt 03.csv").write_bytes(bytes(range(256)) * 20)
    (handed / "empty 04.csv").write_text("", "utf-8")
    (handed / "05 photo.jpg").write_bytes(b"\xff\xd8\xff\xe0 no photograph")
    (handed / "06 nothing.csv").write_text("plan,position,segment,mm\nvelocities,1,ab,\n", "utf-8")
    (handed / "07 strange.csv").write_text("plan,position,segment,mm\nmoons,1,ab,3\n", "utf-8")
    (handed / "nobody.csv").write_text("", "utf-8")
    (handed / "31 32.txt").write_text("", "utf-8")
    done = run(folder, "-o", folder / "out")
    return Handed(folder, done, by_name((folder / "out" / "summary.csv").read_text("utf-8")))


def run(folder: Path, *options: object) -> Result:
    table = ("--variants", folder / "variants.csv")
    return invoke("mark", folder / SCENE, folder / "handed", *table, *TRIALS, *options)


def by_name(text: str) -> dict[str, dict[str, str]]:
    return {row["handed in"]: row for row in csv.DictReader(io.StringIO(text, newline=""))}


READ = ("01", "03", "04", "05", "06", "07", "Petrov 01", "Sidorov 08", "Иванов-02")


def alone(folder: Path, name: str) -> str:
    """Return the JSON report of a hand-in checked alone, by the scene that a teacher would write."""
    number = int(re.findall(r"\d+", name)[0])
    text = variant_text(number, POSITIONS)
    if number == 8:
        text = re.sub(
            r'OA = "\d+ mm"', 'OA = "80 mm"', re.sub(r'AB = "\d+ mm"', 'AB = "370 mm"', text)
        )
    scene = folder / f"slider-{number:02d}.toml"
    scene.write_text(text, "utf-8")
    return invoke("check", scene, folder / "handed" / f"{name}.csv", *TRIALS, "-f", "json").stdout


@pytest.mark.slow
def test_each_is_judged_as_it_would_be_alone(many: Callable[[int, int], int]) -> None:
    """Usually a mistaken one, one whose values are its own, and one of a name besides its number."""
    folder = marked().folder
    for name in READ if many(1, 0) else ("03", "Sidorov 08", "Иванов-02"):
        assert (folder / "out" / "reports" / f"{name}.json").read_text("utf-8") == alone(
            folder, name
        )


def due_points(report: dict[str, Any]) -> Decimal:
    """Return the points by the usual rule, of a single check's JSON: 4 and 10, 16, 4 and 8, 16."""
    lines = [set(one["lines"]) for one in report["mistakes"] if one["kind"] != "unseen"]
    groups: dict[int, Counter[tuple[str, str]]] = {}
    for one in report["readings"]:
        if one["verdict"] == "wrong":
            cause = next((k for k, its in enumerate(lines) if one["line"] in its), -1)
            groups.setdefault(cause, Counter())[one["plan"], one["segment"]] += 1
    lost = Decimal(0)
    for cause, segments in groups.items():
        cost = sum(min(4 * count, 10) for count in segments.values())
        lost += cost if cause < 0 else min(16, cost)
    doubts = sum(one.get("doubt", 0.0) for one in report["readings"])
    lost += min(4 * Decimal(str(round(doubts, 2))), Decimal(8))
    lost += 16 if report["whole"] else 0
    return max(Decimal(0), 100 - lost)


@pytest.mark.slow
def test_marks_follow_from_the_single_reports() -> None:
    of = marked()
    points = {}
    for name in READ:
        report = json.loads((of.folder / "out" / "reports" / f"{name}.json").read_text("utf-8"))
        other = 51 if "variant 15" in of.rows[name]["remarks"] else 0
        points[name] = max(Decimal(0), due_points(report) - other)
        row, counts = of.rows[name], report["counts"]
        assert Decimal(row["points"]) == points[name]
        assert int(row["mark"]) == (
            5 if points[name] >= 85 else 4 if points[name] >= 70 else 3 if points[name] >= 50 else 2
        )
        assert [int(row[key]) for key in ("fine", "doubtful", "wrong")] == list(counts.values())
    assert min(points.values()) < 85 < max(points.values())


@pytest.mark.slow
def test_what_cannot_be_read_is_named_and_the_rest_is_done() -> None:
    of = marked()
    assert of.done.exit_code == 1
    skipped = {name for name, row in of.rows.items() if not row["mark"]}
    assert skipped == {
        "corrupt 03", "empty 04", "05 photo", "06 nothing", "07 strange", "nobody.csv", "31 32.txt",
    }  # fmt: skip
    assert all(of.rows[name]["remarks"] for name in skipped)
    assert "moons" in of.rows["07 strange"]["remarks"]
    assert of.rows.keys() == {*READ, *skipped}


@pytest.mark.slow
def test_a_copy_is_told_and_is_no_part_of_a_mark() -> None:
    rows = marked().rows
    told = {name for name, row in rows.items() if "Alike" in row["remarks"]}
    assert told == {"01", "Petrov 01"}
    assert rows["01"]["mark"] == rows["Petrov 01"]["mark"]


@pytest.mark.slow
def test_another_variant_is_told() -> None:
    rows = marked().rows
    told = {name: row["remarks"] for name, row in rows.items() if "Looks like" in row["remarks"]}
    assert told.keys() == {"Sidorov 08"}
    assert "variant 15" in told["Sidorov 08"]


@pytest.mark.slow
def test_the_gradebook_is_what_learning_platforms_take() -> None:
    of = marked()
    data = (of.folder / "out" / "gradebook.csv").read_bytes()
    lines = data.decode("utf-8").split("\r\n")
    assert lines[0] == '"identifier","mark","feedback"'
    rows = list(csv.reader(io.StringIO(data.decode("utf-8"), newline="")))[1:]
    assert {name for name, _, _ in rows} == {
        "01", "03", "04", "05", "06", "07", "Petrov", "Sidorov", "Иванов",
    }  # fmt: skip
    assert all(mark in "2345" and text.strip() for _, mark, text in rows)


@pytest.mark.turns(1, "forms")
@pytest.mark.slow
def test_all_forms_hold_the_same(tmp_path: Path) -> None:
    of = marked()
    book = load_workbook(of.folder / "out" / "summary.xlsx")
    cells = list(book.active.values)
    found = {row[0]: dict(zip(cells[0], row, strict=True)) for row in cells[1:]}
    assert found.keys() == of.rows.keys()
    assert all(float(of.rows[name]["points"]) == found[name]["points"] for name in READ)
    page = (of.folder / "out" / "summary.html").read_text("utf-8")
    assert all(f"reports/{name}.html" in page for name in ("01", "Petrov%2001"))
    assert not re.search(r'(?:src|href)="(?!reports/)', page)


@pytest.mark.turns(1, "forms")
@pytest.mark.slow
def test_the_same_again_has_the_same_bytes() -> None:
    """In another folder, in one process; and again in the same one, where nothing is made anew."""
    of = marked()
    other = of.folder / "again"
    run(of.folder, "-o", other)
    first, second = (contents(place) for place in (of.folder / "out", other))
    assert first == second
    run(of.folder, "-o", other)
    assert contents(other) == second


def contents(folder: Path) -> dict[str, bytes]:
    found = (path for path in folder.rglob("*") if path.is_file())
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in found
        if ".graphic-tmm" not in path.parts
    }


@pytest.mark.slow
def test_a_class_of_one_scene_without_variants(tmp_path: Path) -> None:
    """In Russian; a rule of its own; status 0, nothing written."""
    scene = tmp_path / "slider.toml"
    scene.write_text(variant_text(1, 6).replace('"en"', '"ru"'), "utf-8")
    place = tmp_path / "handed"
    place.mkdir()
    for k, mind in enumerate((None, wrong_link), 1):
        one = hand_in(1, k, mind=mind, positions=6, mode="mm" if mind is None else "both")
        (place / f"Студент {k}.csv").write_text(one.text, "utf-8")
    rule = tmp_path / "marks.toml"
    rule.write_text('[mark]\nscale = 100\n[asked]\nplans = ["velocities"]\n', "utf-8")
    done = invoke("mark", scene, place, "--marks", rule, "--trials", 40, "-f", "csv", "-l", "ru")
    assert done.exit_code == 0, done.output
    rows = list(csv.DictReader(io.StringIO(done.stdout, newline="")))
    assert [row["работа"] for row in rows] == ["Студент 1", "Студент 2"]
    assert int(rows[0]["оценка"]) > int(rows[1]["оценка"])
    assert "OA" in rows[1]["ошибки"]
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "handed",
        "marks.toml",
        "slider.toml",
    ]
