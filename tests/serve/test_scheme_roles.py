"""Schemes of several drives, of passive links and of arms: what comes of acts, and what stays as it was."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
from support.gallery import SHEETS
from support.slider_sketch import body

from graphic_tmm.errors import TmmError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.read import judged
from graphic_tmm.serve.scheme.act import SchemeAct, scheme

EN = speaking("en")
NEW = Path("scheme.toml")
EXCAVATOR = SHEETS / "excavator" / "scene.toml"
CRANKS = SHEETS / "parallel-cranks" / "scene.toml"
COMMENT = re.compile(r"#.*")


def shown(file: Path, **asked: Any) -> dict[str, Any]:
    return scheme(file.read_bytes(), file, SchemeAct(**asked), EN)


def drawn(places: dict[str, list[float]], links: list[dict[str, Any]], *drives: int) -> Any:
    asked = SchemeAct(sketch={"places": places, "links": links, "drives": list(drives)})
    return scheme(b"", NEW, asked, EN)


FIVE = {"O": [0.1, 0.1], "D": [0.3, 0.1], "A": [0.08, 0.16], "C": [0.33, 0.15], "B": [0.2, 0.25]}


def five_bar() -> list[dict[str, Any]]:
    links = [("O", "D"), ("O", "A"), ("A", "B"), ("B", "C"), ("C", "D")]
    return [body(number, *points) for number, points in enumerate(links)]


def test_two_cranks_are_driven() -> None:
    assert "say which links are driven, 2 of them" in drawn(FIVE, five_bar())["says"]
    one = drawn(FIVE, five_bar(), 1)
    assert (one["mobility"], one["text"]) == (2, None)
    assert "or another link is driven, too" in one["says"]
    made = drawn(FIVE, five_bar(), 1, 4)
    assert (made["mobility"], made["formula"]) == (2, "I(1), I(4) → II(2-3)")
    # a crank begins where it was drawn, in whole degrees
    second = tomllib.loads(made["text"])["drive"][1]
    assert second == {"link": 4, "speed": 0, "at": "59 deg"}
    three = drawn(FIVE, five_bar(), 1, 4, 3)
    assert "W = 2, but 3 links are driven: click one of them" in three["says"]


def test_a_second_drive_comes_into_a_scene_that_has_one_and_no_comment_goes() -> None:
    file = SHEETS / "crank-rocker" / "scene.toml"
    text = file.read_text("utf-8").replace("[drive]", "# how it is driven\n[drive]  # by a motor")
    sketch = scheme(text.encode(), file, SchemeAct(), EN)["sketch"]
    frame, *links = sketch["links"]
    places = {**sketch["places"], "F": [1.0, 0.0], "G": [1.1, 0.1]}
    more = [{**frame, "points": [*frame["points"], "F"]}, *links, body(7, "F", "G")]
    asked = {"places": places, "links": more, "drives": [1, 7]}
    made = scheme(text.encode(), file, SchemeAct(sketch=asked), EN)
    assert "# how it is driven\n[[drive]]  # by a motor\n" in made["text"]
    first, second = tomllib.loads(made["text"])["drive"]
    # where a point is extreme hangs on both drives
    assert "zero" in tomllib.loads(text)["drive"]
    assert "zero" not in first
    assert second == {"link": 7, "speed": 0, "at": "45 deg"}
    assert set(COMMENT.findall(text)) <= set(COMMENT.findall(made["text"]))
    # taken away with its link it is one again
    again = scheme(made["text"].encode(), file, SchemeAct(sketch=sketch), EN)
    assert again["mobility"] == 1
    assert len(tomllib.loads(again["text"])["drive"]) == 1


def test_a_drive_that_stands_elsewhere_begins_elsewhere() -> None:
    """Wherever the first stands when it is drawn on: what it went by then is taken off."""
    sketch = shown(EXCAVATOR, at=2.0)["sketch"]
    links = {one["number"]: one for one in sketch["links"]}
    way = links[5]["guides"]["w"]["angle"]
    pin, pivot = (complex(*sketch["places"][letter]) for letter in "MH")
    longer = pivot + (pin - pivot) * (abs(pin - pivot) + 0.1) / abs(pin - pivot)
    sketch["places"]["M"] = [longer.real, longer.imag]
    made = shown(EXCAVATOR, sketch=sketch)
    assert [one["link"] for one in tomllib.loads(made["text"])["drive"]] == [3, 6]
    assert tomllib.loads(made["text"])["drive"][1]["at"] == "2.6 m"
    assert made["at"] == pytest.approx(2.0)
    assert abs(complex(*made["sketch"]["places"]["M"]) - longer) < 2e-3
    assert made["sketch"]["links"][5]["guides"]["w"]["angle"] == pytest.approx(way, abs=0.1)


def test_the_second_drive_becomes_the_first() -> None:
    sketch = shown(EXCAVATOR)["sketch"]
    made = shown(EXCAVATOR, sketch={**sketch, "drives": [6, 3]})
    first, second = tomllib.loads(made["text"])["drive"]
    assert (first["link"], first["speed"], first["positions"]) == (6, "0.1 m/s", 4)
    assert second["link"] == 3
    assert {"from", "to"} <= first.keys()
    places = made["sketch"]["places"]
    assert all(abs(complex(*places[k]) - complex(*z)) < 2e-3 for k, z in sketch["places"].items())


def test_fields_of_several_drives_say_whose_they_are() -> None:
    labels = {one["key"]: one["label"] for one in shown(EXCAVATOR)["fields"]}
    assert labels["drive 2, at"] == "link 6: where it stands in the zero position"
    assert labels["drive 1, from"].startswith("link 3: where the row begins")


PARALLEL = {"O": [0.1, 0.1], "A": [0.13, 0.15], "B": [0.331, 0.152], "C": [0.3, 0.102]}
PARALLEL |= {"D": [0.2, 0.1], "E": [0.231, 0.151]}


def cranks(*, passive: bool) -> list[dict[str, Any]]:
    third = {**body(4, "D", "E"), **({"passive": True} if passive else {})}
    links = [("O", "C", "D"), ("O", "A"), ("A", "B", "E"), ("C", "B")]
    return [*(body(number, *points) for number, points in enumerate(links)), third]


def test_a_third_crank_is_said_to_repeat_what_two_hold() -> None:
    for drives in ((), (1,)):
        made = drawn(PARALLEL, cranks(passive=False), *drives)
        assert made["mobility"] == 0
        assert "links 1, 3, 4 go parallel: the tool makes link 4 passive" in made["says"]
    askew = {**PARALLEL, "E": [0.231, 0.18]}
    assert "go parallel" not in drawn(askew, cranks(passive=False), 1)["says"]


def test_a_parallelogram_that_is_drawn_nearly_is_one() -> None:
    made = drawn(PARALLEL, cranks(passive=True), 1)
    assert (made["mobility"], made["formula"]) == (1, "I(1) → II(2-3)")
    mechanism = judged(made["text"].encode(), NEW).mechanism
    assert mechanism is not None
    places = {k: complex(*z) for k, z in made["sketch"]["places"].items()}
    assert abs(places["B"] - places["A"] - places["C"] + places["O"]) < 1e-12
    assert [one.number for one in mechanism.passive] == [4]
    side = mechanism.by_number[3].side
    assert side is not None
    assert side.flips_at == (0.0, 180.0)
    larger = SchemeAct(sketch=made["sketch"], typed={"lengths.r": "300 mm"}, scale=True)
    found = scheme(made["text"].encode(), NEW, larger, EN)
    lengths = tomllib.loads(found["text"])["lengths"]
    assert lengths["r"] == "300 mm"
    assert abs(float(lengths["b"].split()[0]) / 300 - 200 / 58) < 0.01
    with pytest.raises(TmmError, match=r"link 4 is passive|flips_at"):
        scheme(made["text"].encode(), NEW, SchemeAct(typed={"link 1, points.A[1]": "50 mm"}), EN)


def test_another_of_three_cranks_is_passive_and_comments_stay() -> None:
    text = CRANKS.read_text("utf-8")
    sketch = shown(CRANKS)["sketch"]
    roles = {3: {"passive": True}, 4: {"passive": False}}
    links = [one | roles.get(one["number"], {}) for one in sketch["links"]]
    made = shown(CRANKS, sketch={**sketch, "links": links})
    assert made["errors"] == []
    tables = {one["number"]: one for one in tomllib.loads(made["text"])["link"]}
    assert tables[3]["passive"] is True
    assert not {"side", "flips_at"} & tables[3].keys()
    assert tables[4]["flips_at"] == ["0 deg", "180 deg"]
    assert "passive" not in tables[4]
    assert set(COMMENT.findall(text)) <= set(COMMENT.findall(made["text"]))


ECCENTRICS = """title = "T"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, "20 mm"], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = ["50 mm", 0] }
[[link]]
number = 2
points = { O = [0, "3 mm"], E = ["30 mm", "3 mm"] } # the other eccentric
weld = { to = 1, angle = "120 deg" }
[[link]]
number = 3
points = { A = [0, 0], B = ["150 mm", 0] }
[[link]]
number = 4
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "60 rpm"
"""


def test_an_arm_is_drawn_by_itself_and_follows() -> None:
    file, data = NEW, ECCENTRICS.encode()
    sketch = scheme(data, file, SchemeAct(), EN)["sketch"]
    links = {one["number"]: one for one in sketch["links"]}
    assert (links[1]["points"], links[2]["points"], links[2]["weld"]) == (["O", "A"], ["O", "E"], 1)
    assert scheme(data, file, SchemeAct(sketch=sketch), EN)["text"] == ECCENTRICS
    x, y = sketch["places"]["E"]
    moved = {**sketch, "places": {**sketch["places"], "E": [-y, x]}}
    made = scheme(data, file, SchemeAct(sketch=moved), EN)
    assert made["text"] == ECCENTRICS.replace("120 deg", "210 deg").replace("210", "-150")
    del links[2]["weld"]
    apart = scheme(data, file, SchemeAct(sketch=sketch), EN)
    assert (apart["mobility"], apart["text"]) == (2, None)


def test_links_are_welded() -> None:
    places = {"O": [0.1, 0.1], "A": [0.13, 0.15], "B": [0.331, 0.132], "E": [0.09, 0.16]}
    frame = {**body(0, "O"), "guides": {"x": {"through": [0, 0.132], "angle": 0}}}
    slider = body(3, "B", slides=[{"on": 0, "along": "x"}])
    links = [frame, body(1, "O", "A"), {**body(5, "O", "E"), "weld": 1}, body(2, "A", "B"), slider]
    made = drawn(places, links, 1)
    assert made["formula"] == "I(1) → II(2-3)"
    table = next(one for one in tomllib.loads(made["text"])["link"] if one["number"] == 5)
    assert table["weld"] == {"to": 1, "angle": "40.4 deg"}
    assert next(one for one in made["fields"] if one["key"] == "link 5, weld.angle")["text"]
    wrong = [frame, body(1, "O", "A"), {**body(5, "B", "E"), "weld": 1}, *links[3:]]
    assert "share no letter" in drawn(places, wrong, 1)["says"]
