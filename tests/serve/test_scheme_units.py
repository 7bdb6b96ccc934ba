"""Bare numbers typed beside a scheme have the unit of their field."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.slider_sketch import crank_and_slider

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.coordinates import SPEED
from graphic_tmm.scene.values import quantity
from graphic_tmm.serve.form import blank
from graphic_tmm.serve.scheme.act import SchemeAct, scheme
from graphic_tmm.serve.scheme.units import with_unit

EN = speaking("en")
BARE = [
    ("OA", "", "110.5", "110.5 mm", ""),
    ("OA", "", "110,5", "110,5 mm", ""),
    ("link 1: its angular speed", "0", "60", "60 rad/s", "rad/s"),
    ("link 1: its angular speed", '"380 rpm"', "60", "60 rpm", ""),
    ("link 1: its angular speed", "6.5", "60", "60 rad/s", "rad/s"),
    ("link 2: its mass", "", "3", "3 kg", "kg"),
    ("link 2: its moment of inertia about the mass centre", "", "0.02", "0.02 kg*m^2", "kg·m²"),
    ("link 1: what the link is called", "", "3", "3", ""),
]


@pytest.mark.parametrize(("label", "begun", "typed", "holds", "unit"), BARE)
def test_a_bare_number_has_the_unit_of_its_field(
    label: str, begun: str, typed: str, holds: str, unit: str
) -> None:
    file = Path("scheme.toml")
    text = scheme(b"", file, SchemeAct(sketch=crank_and_slider()), EN)["text"]
    text = text.replace("speed = 0", f"speed = {begun}") if "speed" in label else text
    fields = {one["label"]: one for one in scheme(text.encode(), file, SchemeAct(), EN)["fields"]}
    assert fields[label]["unit"] == unit
    typed_in = {fields[label]["key"]: typed}
    made = scheme(text.encode(), file, SchemeAct(typed=typed_in), EN)
    shown_now = {one["label"]: one["text"] for one in made["fields"]}
    assert shown_now[label] == holds


def test_what_a_bare_number_is_in_is_taken_from_what_is_written() -> None:
    field = blank(quantity("length"), None)._replace(in_quotes=True)
    named = field._replace(text="AB")
    assert with_unit("140", field._replace(text="0.659 m"), {}) == "140 m"
    assert with_unit("140", field._replace(text="659 мм"), {}) == "140 мм"
    assert with_unit("140", named, {}) == "140 mm"
    assert with_unit("140", named, {"lengths": {"AB": "0.6 m"}}) == "140 m"
    assert with_unit("0.14", field._replace(text="0.65", in_quotes=False), {}) == "0.14 m"
    assert with_unit("140 cm", field._replace(text="659 mm"), {}) == "140 cm"
    drive = {"drive": {"link": 3}, "link": [{"number": 3, "slides": {"on": "frame", "along": "x"}}]}
    speed = blank(SPEED, None)._replace(path=("drive", "speed"), text="0")
    assert with_unit("2", speed, drive) == "2 m/s"
    assert with_unit("2", speed, {"drive": {"link": 1}}) == "2 rad/s"
