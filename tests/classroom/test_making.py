"""A batch makes the same bytes as the single commands, whoever does it; and what it is asked travels."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest
from support.batches import files_of
from support.command import printed
from support.gallery import SHEETS

from graphic_tmm.classroom.batch.run import run
from graphic_tmm.classroom.batch.work import Work, digest, done
from graphic_tmm.classroom.making import MAKES, Request, make_request, work
from graphic_tmm.classroom.variants.variant import Value, Variant, base, source_of, text_of
from graphic_tmm.errors import SceneError
from graphic_tmm.files import write
from graphic_tmm.fitting.composition import composition_file
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheet_files

SCENE = SHEETS / "shaper"


@pytest.fixture(scope="module")
def composition() -> str:
    scene = read(SCENE)
    files = sheet_files(scene, (), composition=True)[1]
    return str(files[composition_file(scene.source).name])


def works(composition: str, makes: tuple[str, ...] = tuple(MAKES)) -> list[Work]:
    of = base(SCENE)
    some = [Variant(f"в{k}", (Value("OA", f"{108 + 4 * k}"),)) for k in range(2)]
    asked = Request("", "", makes, composition=composition, lent=True)
    return [
        work(one.name, asked._replace(text=text_of(of, one), source=source_of(of, one).name))
        for one in some
    ]


def by_commands(work: Work, home: Path) -> dict[str, bytes]:
    """What the commands for what a work makes write of its scene, the composition that it tells beside it."""
    name, asked = work.given
    file, out = home / asked.source, home / name
    file.write_text(asked.text, encoding="utf-8")
    if asked.composition:
        told = done(work._replace(given=(name, asked._replace(makes=("scene",))))).files
        write(out, {path.partition("/")[2]: text for path, text in told.items()})
        composition_file(str(file)).write_bytes((out / "composition.toml").read_bytes())
    formats = {"draw": (), "note": ("-f", "md"), "page": ()}
    for command in asked.makes:
        if command in formats:
            printed(command, file, "-o", out, *formats[command])
    (out / f"{file.stem}.csv").write_text(printed("table", file, "-f", "csv"), encoding="utf-8")
    return {f"{name}/{path}": data for path, data in files_of(out).items()}


@pytest.mark.turns(1, "bytes")
@pytest.mark.slow
def test_the_bytes_are_those_of_the_commands(composition: str, tmp_path: Path) -> None:
    found = [*works(composition)[:1], *works(composition, ("draw", "table", "scene"))[1:]]
    due = {}
    for one in found:
        due |= by_commands(one, tmp_path)
    assert len(due) >= 6
    ran = run(found, tmp_path / "two", executor=2)
    assert ran.failed == {}
    assert files_of(tmp_path / "two") == dict(sorted(due.items()))


@pytest.mark.turns(1, "bytes")
@pytest.mark.slow
def test_without_a_composition_too(tmp_path: Path) -> None:
    (one, _) = works("", ("draw", "table"))
    due = by_commands(one, tmp_path)
    found = done(one).files
    assert len(found) > 1
    for name, text in found.items():
        assert (text.encode() if isinstance(text, str) else text) == due[name], name


def test_works_travel_and_are_known_by_what_they_say(composition: str) -> None:
    found = works(composition)
    again = [pickle.loads(pickle.dumps(one)) for one in found]
    assert again == found
    assert [digest(one) for one in again] == [digest(one) for one in works(composition)]
    assert len({digest(one) for one in [*found, *works("")]}) == 4


def test_a_scene_that_is_not_good_is_refused_in_its_own_words() -> None:
    (one, _) = works("")
    name, asked = one.given
    with pytest.raises(SceneError, match="в0"):
        make_request(
            (name, asked._replace(text=asked.text.replace("22 kg", "-"), source="в0.toml"))
        )


def test_what_is_made_in_which_formats_stands_in_the_name() -> None:
    asked = Request("", "x.toml", ("draw", "table"), sheets=("svg", "pdf"))
    assert work("7", asked).name == "7/draw-svg-pdf+table-csv"
