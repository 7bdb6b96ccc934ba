"""Title blocks of the sheets of a scene: names, designations, the check line."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from support.gallery import SHEETS, paper

from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.compose import composed
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.lettering.letters import missing, plain
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import sheets

ORDERS = (SheetOrder("A2", ("lettering",)), SheetOrder("A2", ("symbols",)))


def texts(sheet: Sheet) -> str:
    return " ".join(plain(label.text) for label in sheet.drawings[0].labels)


def scene(**changes: object) -> Scene:
    return replace(read(SHEETS / "lettering"), **{"sheets": ORDERS, **changes})


def test_each_sheet_bears_its_own_name_and_designation_and_so_do_those_that_follow_it() -> None:
    named = [
        replace(order, name=name, designation=mark)
        for order, name, mark in zip(ORDERS, ("Шрифт", "Знаки"), ("К.1", "К.2"), strict=True)
    ]
    found = sheets(scene(sheets=tuple(named)))[1]
    assert len(found) > 2
    told = [texts(sheet) for sheet in found]
    first = next(k for k, text in enumerate(told) if "Знаки" in text)
    assert all("Шрифт" in text and "К.1" in text for text in told[:first])
    assert all("Знаки" in text and "К.2" in text for text in told[first:])


@pytest.mark.parametrize(("language", "letters"), [("ru", "ТММ"), ("en", "TMM")])
def test_sheets_without_a_designation_share_one_but_for_those_named(
    language: str, letters: str
) -> None:
    told = [texts(sheet) for sheet in sheets(scene(language=language, title_block={}))[1]]
    assert len(told) > 1
    assert all(f"{letters}.01.01.000" in text for text in told)
    assert all(scene().title in text for text in told)
    mixed = (ORDERS[0], replace(ORDERS[1], name="Знаки"))
    own = scene(language=language, title_block={}, sheets=mixed)
    told = [texts(sheet) for sheet in sheets(own)[1]]
    assert f"{letters}.01.01.000" in told[0]
    assert f"{letters}.01.02.000" in told[-1]


def test_the_title_block_tells_what_a_sheet_does_not() -> None:
    block = {"name": "Проект", "designation": "КП 7"}
    mixed = (ORDERS[0], replace(ORDERS[1], name="Знаки"))
    told = [texts(sheet) for sheet in sheets(scene(sheets=mixed, title_block=block))[1]]
    assert all("КП 7" in text for text in told)
    assert "Проект" in told[0]
    assert "Знаки" in told[-1]
    assert "Проект" not in told[-1]


@pytest.mark.parametrize(
    ("whole", "own"),
    [
        ("ТММ.08.00.000", ["ТММ.08.01.000", "ТММ.08.02.000"]),
        ("КП 00.00.00", ["КП 00.00.01", "КП 00.00.02"]),
        ("М2100.7", ["М2100.7.01", "М2100.7.02"]),
    ],
)
def test_each_document_of_a_project_has_its_number_in_the_designation(
    whole: str, own: list[str]
) -> None:
    """Two named sheets are two documents of one project; alone, a sheet is the project."""
    named = tuple(
        replace(order, name=name) for order, name in zip(ORDERS, ("Шрифт", "Знаки"), strict=True)
    )
    block = {"designation": whole}
    told = [texts(sheet) for sheet in sheets(scene(sheets=named, title_block=block))[1]]
    assert own[0] in told[0]
    assert own[1] in told[-1]
    assert own[1] not in told[0]
    (single, *_) = sheets(scene(sheets=named[:1], title_block=block))[1]
    assert whole in texts(single)
    assert own[0] not in texts(single)


def test_sheets_of_one_designation_are_counted_together() -> None:
    """Whatever they are called, and those behind them that say nothing bear it, too."""
    one = replace(ORDERS[1], designation="К.1", name="Шрифт")
    two = replace(ORDERS[1], designation="К.1", name="Знаки")
    found = sheets(scene(sheets=(one, two, ORDERS[1]), title_block={"designation": "К.0"}))[1]
    blocks = [[plain(label.text) for label in sheet.drawings[0].labels] for sheet in found]
    assert all("К.1" in block for block in blocks)
    assert str(len(found)) in blocks[0]
    assert [str(k + 1) in block for k, block in enumerate(blocks)] == [True] * len(found)


def scales(found: tuple[Sheet, ...]) -> list[str]:
    """What the title blocks of sheets tell of a scale."""
    told = [texts(sheet).split() for sheet in found]
    return ["".join(text for text in one if re.fullmatch(r"[0-9,]+:[0-9,]+", text)) for one in told]


WANTED = {
    "crank-press": ["1:2", ""],
    "arc-cam": ["2,5:1"],
    "gear-pair": [""],
    "planetary": ["1:2,5"],
    "lever": ["", ""],
    "project": ["1:4", "", "", ""],
}


@pytest.mark.every
@pytest.mark.parametrize("name", WANTED)
def test_a_sheet_tells_the_standard_scale_of_its_own_main_view(name: str) -> None:
    """The plan of positions leads its sheet; groups of one sheet differ; 2.37:1 is no scale of ГОСТ 2.302.

    Project: mechanism 1:4; groups 1:2, 1:5 and 1:1; graphs; then a cam, gears, a train by their own.
    """
    assert scales(paper(name)[1])[: len(WANTED[name])] == WANTED[name]


def test_the_scale_that_the_author_writes_stands_on_all_sheets() -> None:
    found = paper("planetary")[0]
    block = {**found.scene.title_block, "scale": "1:7"}
    assert scales(composed(replace(found.scene, title_block=block), found.boards).sheets) == ["1:7"]


def test_a_scene_says_all_of_it(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    head = (
        'title = "Буквы"\n[[sheet]]\nplace = ["lettering"]\nname = "Шрифт"\ndesignation = "К.1"\n'
    )
    file.write_text(head + "[title_block]\nprint_check = false\n", encoding="utf-8")
    made = read(file)
    assert (made.sheets[0].name, made.sheets[0].designation) == ("Шрифт", "К.1")
    assert not made.print_check
    (frame, *_), *_ = (sheet.drawings for sheet in sheets(made)[1])
    assert not any(key == "check-line" for one in frame.strokes for key, _ in one.data)
    file.write_text(head + '[title_block]\nprint_check = "no"\n', encoding="utf-8")
    with pytest.raises(SceneError, match="print_check"):
        read(file)
    file.write_text(head.replace("К.1", "К☃"), encoding="utf-8")
    with pytest.raises(SceneError, match="designation"):
        read(file, missing=missing)
