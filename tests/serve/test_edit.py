"""Values set in scenes: the scene reads them back, all else stays as it was, and refusals leave it alone."""

from __future__ import annotations

import random
import tomllib
from pathlib import Path
from typing import Any

import pytest
from support.gallery import ROOT

from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import judged
from graphic_tmm.serve.edit import edited, source_of
from graphic_tmm.serve.form import Field, form

SCENES = sorted((ROOT / "sheets").glob("*/scene.toml"))
WINDROWER = ROOT / "sheets" / "windrower" / "scene.toml"


def fields(data: bytes, file: Path) -> list[Field]:
    return [one for group in form(data, file) for one in group.fields]


def comments(data: bytes) -> list[str]:
    """The comments of a scene of the package, none of which holds a sign of a number in a text."""
    return [line.partition("#")[2] for line in data.decode().splitlines() if "#" in line]


def retyped(one: Field, chance: random.Random) -> str:
    """Something else for a field, of which many are refused."""
    number, _, unit = one.text.partition(" ")
    try:
        other = f"{float(number) * chance.choice([1.01, 0.99, 2]):.6g}"
    except ValueError:
        return chance.choice([*one.choices, "6", "95 mm", "", "true", "[2, 6]", f"{one.text} "])
    return f"{other} {unit}".strip() if chance.random() < 0.8 else other


@pytest.mark.parametrize("file", SCENES, ids=lambda file: file.parent.name)
def test_one_line_of_a_scene_changes_or_none(file: Path) -> None:
    chance = random.Random(file.parent.name)
    data = file.read_bytes()
    for one in chance.sample(fields(data, file), 6):
        typed = retyped(one, chance)
        try:
            made = edited(data, {one.key: typed}, file)
        except SceneError:
            continue
        judged(made, file)
        assert comments(made) == comments(data)
        before, after = data.decode().splitlines(), made.decode().splitlines()
        kept = [line for line in after if line in before]
        assert len(after) - len(kept) <= (1 if one.written or one.path[0] in doc_of(data) else 3)
        now = {other.key: other.text for other in fields(made, file)}
        # positions of a list need no brackets
        bare = [f"[{typed}]"] if one.kind == "list" else []
        assert now.get(one.key, "") in (typed.strip(), *bare)


def doc_of(data: bytes) -> dict[str, Any]:
    return tomllib.loads(data.decode())


@pytest.mark.parametrize("file", SCENES, ids=lambda file: file.parent.name)
def test_typing_what_is_there_changes_nothing(file: Path) -> None:
    data = file.read_bytes()
    there = fields(data, file)
    assert edited(data, {one.key: one.text for one in there[:150]}, file) == data


REFUSED = {
    "no unit": ("drive.speed", "400", 'write "400 rpm"'),
    "a wrong unit": ("drive.speed", "400 mm", "an angular speed is wanted"),
    "an unknown unit": ("link 3, mass", "25 kq", "not known"),
    "a giant number": ("drive.speed", "1e400 rpm", "not a finite number"),
    "a giant whole number": ("drive.positions", "9" * 5000, "a whole number is wanted"),
    "out of bounds": ("drive.positions", "0", "a whole number 1 to 100000"),
    "an unknown key": ("drive.sped", "1", 'did you mean "speed"?'),
    "an unknown section": ("drve.speed", "1", '"drve" means nothing here'),
    "an unknown link": ("link 9, mass", "1 kg", "means nothing here"),
    "no key at all": ("", "1 kg", "means nothing here"),
    "a key of a value": ("title.x", "1", "change it in the file itself"),
    "a needed key taken out": ("drive.speed", "", '"speed" is missing'),
    "a word": ("drive.turns", "sideways", 'it is one of "counterclockwise"'),
    "a list for a number": ("drive.positions", "[1, 2]", "a whole number is wanted"),
    "two keys in one": ("drive.positions", "12\nlink = 2", "a whole number is wanted"),
    "a letter that is no point": ("diagrams.point", "Q", "no point"),
    "half a character": ("title", "a\ud800", "half of a character"),
    "a bell": ("title", "a\x07", "U+0007"),
    "a long text": ("title", "a" * 300_000, "too large"),
}


@pytest.mark.parametrize(("key", "typed", "says"), REFUSED.values(), ids=REFUSED)
def test_refused(key: str, typed: str, says: str) -> None:
    with pytest.raises(SceneError) as raised:
        edited(WINDROWER.read_bytes(), {"title": "Другая", key: typed}, WINDROWER)
    assert says in str(raised.value)


def test_a_refusal_tells_key_and_line() -> None:
    with pytest.raises(SceneError) as raised:
        edited(WINDROWER.read_bytes(), {"drive.speed": "400"}, WINDROWER)
    (fault,) = raised.value.faults
    lines = WINDROWER.read_text("utf-8").splitlines()
    assert (fault.key, lines[fault.line - 1].split()[0]) == ("drive.speed", "speed")


def test_a_number_that_had_a_unit_keeps_needing_one_and_one_that_had_none_does_not() -> None:
    data = WINDROWER.read_bytes()
    plain = edited(data, {"drive.acceleration": "20"}, WINDROWER)
    assert doc_of(plain)["drive"]["acceleration"] == 20
    other = edited(plain, {"drive.acceleration": "0.2 rad/s^2"}, WINDROWER)
    assert doc_of(other)["drive"]["acceleration"] == "0.2 rad/s^2"
    assert doc_of(edited(data, {"flywheel.delta": "0,05"}, WINDROWER))["flywheel"]["delta"] == 0.05
    assert doc_of(edited(data, {"flywheel.delta": "5 %"}, WINDROWER))["flywheel"]["delta"] == "5 %"


@pytest.mark.parametrize(
    ("typed", "written"),
    [
        ("2, 6, 8", "[2, 6, 8]"),
        ("2, 3*", '[2, "3*"]'),
        ("[1, 2]", "[1, 2]"),
        ("all", '"all"'),
    ],
)
def test_a_list_needs_no_brackets(typed: str, written: str) -> None:
    fields = [one for group in form(WINDROWER.read_bytes(), WINDROWER) for one in group.fields]
    (field,) = (one for one in fields if one.key == "drive.accelerations")
    assert source_of(typed, field, "") == written


def test_lists_texts_switches_and_points() -> None:
    changes = {
        "drive.accelerations": "all",
        "drive.extra": '["other extreme", "105 deg"]',
        "title": 'Кулиса "новая"',
        "effects.gravity": "false",
        "frame.B[1]": "0.001 m",
        "link 2, slides.on": "3",
    }
    doc = doc_of(edited(WINDROWER.read_bytes(), changes, WINDROWER))
    assert doc["drive"]["accelerations"] == "all"
    assert doc["drive"]["extra"] == ["other extreme", "105 deg"]
    assert doc["title"] == 'Кулиса "новая"'
    assert doc["effects"]["gravity"] is False
    assert doc["frame"]["B"] == ["0.001 m", "-OB"]


def test_a_scene_with_faults_can_be_mended_one_by_one() -> None:
    text = WINDROWER.read_text("utf-8")
    broken = text.replace('"380 rpm"', '"380 mm"').replace('"8 kg"', '"8 kq"').encode()
    with pytest.raises(SceneError):
        edited(broken, {"drive.speed": "400 mm"}, WINDROWER)
    better = edited(broken, {"drive.speed": "380 rpm"}, WINDROWER)
    assert edited(better, {"link 1, mass": "8 kg"}, WINDROWER) == WINDROWER.read_bytes()


def test_what_is_no_toml_has_no_form_and_takes_no_edit() -> None:
    for data in (b"title = ", b"\xff\xfe", b"a = " + b"[" * 5000):
        with pytest.raises(SceneError):
            form(data, WINDROWER)
        with pytest.raises(SceneError):
            edited(data, {"title": "x"}, WINDROWER)


def test_carriage_returns_and_the_mark_of_a_text_stay() -> None:
    data = b"\xef\xbb\xbf" + WINDROWER.read_bytes().replace(b"\n", b"\r\n")
    made = edited(data, {"drive.speed": "381 rpm", "drive.acceleration": "0"}, WINDROWER)
    assert made.startswith(b"\xef\xbb\xbf")
    assert made.count(b"\n") == made.count(b"\r\n") == data.count(b"\n") + 1
    assert judged(made, WINDROWER).mechanism is not None


def test_too_many_values_at_once() -> None:
    with pytest.raises(SceneError, match="too many"):
        edited(WINDROWER.read_bytes(), {f"lengths.l{k}": "1 m" for k in range(201)}, WINDROWER)
