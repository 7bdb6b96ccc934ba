"""Nothing of one language stands in an output of the other: five scenes of their own, both ways.

A scene is in one language and is asked for in the other; symbols, units, names of files and keys may stay.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from support.command import invoke
from support.found_once import found_once as found_once
from support.leftovers import english, leftovers, of_page, of_svg
from support.scenes import MECHANISM, calling

from graphic_tmm.__main__ import main
from graphic_tmm.checking import check as checking
from graphic_tmm.readers.protocol import plans
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene

BARE = 'title = "T"\nlanguage = "en"\n'
DRIVEN = MECHANISM.replace("positions = 8", "positions = 8\naccelerations = [1, 2]")
ARCS = '[arc_cam]\nbase = "20 mm"\ndistance = "22 mm"\nnose = "7 mm"\nflank = "straight"\nroller = "9 mm"\n'
SCENES = {
    "forces": (DRIVEN, ("effects", "load", "forces", "friction")),
    "diagrams": (DRIVEN, ("diagrams", "indicator", "flywheel")),
    "engine": (DRIVEN, ("indicator", "engine")),
    "cam and gears": (BARE, ("cam", "gears")),
    "train and arcs": (BARE, ("planetary", ARCS)),
}
LANGUAGES = ("en", "ru")
BOTH = "train and arcs"
"""The scene that is asked for in English too: that code holds no Russian text is proven in `test_catalogue`."""
TEX = re.compile(r"\$[^$]*\$")
CHOICES = re.compile(r"\[[^\]]*\]")
"""What options may be, and are: words that are typed."""


def written(name: str, language: str, folder: Path) -> tuple[Path, str]:
    """Write a scene whose own language is the other one; return its file and what it says."""
    head, sections = SCENES[name]
    other = next(one for one in LANGUAGES if one != language)
    head = head.replace('language = "en"', f'language = "{other}"')
    file = calling(folder, *sections, sheet="", head=head)
    return file, file.read_text(encoding="utf-8")


def ran(language: str, *words: object) -> str:
    """Return what a command prints for people, on both streams; the check may find something."""
    done = invoke(*words, "-l", language)
    assert done.exit_code in (0, 1), (words, done.output)
    return f"{done.stdout}\n{done.stderr}"


def drawn(file: Path, language: str, folder: Path) -> Iterator[tuple[str, str]]:
    """Yield what is written and printed of a scene, by name."""
    yield "draw", ran(language, "draw", file, "-f", "svg,html", "-o", folder / "drawn")
    yield "note", ran(language, "note", file, "-f", "md", "-o", folder / "note")
    words = ("--readings", "--keys", "none", "-j", "0")
    yield "task", ran(language, "task", file, "-o", folder / "task", *words)
    readers = {
        ".svg": of_svg,
        ".html": of_page,
        ".md": lambda told: TEX.sub("", told),
        ".csv": without_plans,
    }
    for path in sorted(folder.rglob("*.*")):
        if path.suffix in readers:
            said = readers[path.suffix](path.read_text(encoding="utf-8"))
            yield str(path.relative_to(folder)), said


def told(file: Path, language: str, folder: Path) -> Iterator[tuple[str, str]]:
    """Yield what is printed of a scene, by name; readings of 7 mm each are judged.

    What accuracy costs is told of a cam alone: a mechanism is drawn dozens of times for it.
    """
    for words in (("table",), ("steps", "--why")):
        yield " ".join(words), ran(language, words[0], file, *words[1:])
    yield "table -f csv", without_plans(ran(language, "table", file, "-f", "csv"))
    if "[cam]" in file.read_text(encoding="utf-8"):
        yield "accuracy", ran(language, "accuracy", file, "--trials", "10", "--no-time")
    yield "template", without_plans(ran(language, "template", file))
    short = ran(language, "template", file, "--short")
    yield "short", without_plans(short)
    cells = [
        re.split("[,;]", row) for row in short.splitlines() if row.endswith((",,,,,", ";;;;;"))
    ]
    rows = [",".join([*row[:3], "7"]) for row in cells]
    readings = folder / "readings.csv"
    readings.write_text("\n".join(["plan,position,segment,mm", *rows]), encoding="utf-8")
    for form in ("text", "html"):
        report = ran(language, "check", file, readings, "-f", form, "--trials", "20")
        yield f"check {form}", of_page(report) if form == "html" else report


def without_plans(rows: str) -> str:
    """A table in CSV without names of plans as they are typed: in its first column, in brackets of a remark."""
    typed = captions("ru")
    return re.sub(
        r"(?m)(?:^|(?<=\())[^,;()\n]+(?=[,;)])", lambda n: "" if n[0] in typed else n[0], rows
    )


@pytest.fixture
def judged_once(found_once: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """All forms of a report tell of the same: a scene, which is read once, has its readings judged once."""
    judge, reports = checking.check, {}

    def check(scene: Scene, *told: object, **how: object) -> object:
        if id(scene) not in reports:
            reports[id(scene)] = judge(scene, *told, **how)  # type: ignore[arg-type]
        return reports[id(scene)]

    monkeypatch.setattr(checking, "check", check)


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.usefixtures("judged_once")
def test_what_is_drawn_and_told_is_in_one_language(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    for language in LANGUAGES if name == BOTH or many(1, 0) else ("ru",):
        folder = tmp_path / language
        folder.mkdir()
        file, own = written(name, language, folder)
        names = re.compile("|".join(re.escape(str(one)) for one in (file, folder, tmp_path.name)))
        every = [*drawn(file, language, folder), *told(file, language, folder)]
        counted = {what: leftovers(names.sub("", text), language, own) for what, text in every}
        assert len(counted) > 12
        assert {what: words for what, words in counted.items() if words} == {}


@pytest.mark.parametrize("language", LANGUAGES)
def test_helps_keys_and_new_scenes_are_in_one_language(language: str, tmp_path: Path) -> None:
    commands = main.list_commands(None)  # type: ignore[arg-type]
    helps = {name: ran(language, name, "--help") for name in commands}
    helps["all"] = ran(language, "--help")
    outputs = {name: CHOICES.sub("", text) for name, text in helps.items()}
    outputs["keys"] = re.sub("`[^`]*`", "", ran(language, "keys"))
    outputs["schema"] = "\n".join(re.findall('"description": "(.*)"', ran(language, "schema")))
    for line in ran(language, "new", "--list").splitlines():
        if line:
            name = line.split()[0]
            ran(language, "new", tmp_path / name, name)
            outputs[f"new {name}"] = (tmp_path / name / "scene.toml").read_text("utf-8")
    assert len(outputs) > 30
    counted = {what: leftovers(text, language) for what, text in outputs.items()}
    assert {what: words for what, words in counted.items() if words} == {}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_plan_has_a_name_for_people(language: str) -> None:
    words = captions(language)
    assert not [plan for plan in plans() if leftovers(words[plan], language)]


def test_what_is_left_over_is_found() -> None:
    assert len(english()) > 1000
    assert leftovers("Strike the compass, план", "ru") == ["Strike", "the", "compass"]
    assert leftovers("the plan, план of M. Иванов", "en", "Иванов") == ["план"]
    assert leftovers("μ_v = 2 м/с, omega2, SVG, SCENE, [drive] speed, π", "ru") == []
