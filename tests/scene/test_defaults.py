"""Every default and every example, as people read it, is accepted as it is printed."""

from __future__ import annotations

import tomllib
from dataclasses import MISSING
from typing import Any

from support.boards import in_usual_size
from support.declared_keys import ALL
from support.scenes import slider_crank

from graphic_tmm.language.catalogue import languages, speaking
from graphic_tmm.readers.table import table
from graphic_tmm.scene import keys
from graphic_tmm.scene.declare import Flaw, Key
from graphic_tmm.scene.new import example_of
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.tables import key_schema

SCENE = slider_crank(
    'speed = 1\n[[load]]\nlink = 3\npoint = "B"\nforce = "1 N"\ndirection = 0\n'
    '[forces]\npositions = ["all"]'
)


def _taken(one: Key, at: str, value: Any) -> Any:
    found: list[Flaw] = []
    taken = one.kind.understood(value, (at,), {}, found)
    assert not any(told.fault for told in found), (at, value, found)
    return taken


def test_all_keys_are_walked() -> None:
    assert len(ALL) > 250
    assert {"forces.positions", "link.Slide.offset", "frame.Guide.angle"} <= dict(ALL).keys()


def test_a_default_is_accepted_as_it_is_printed() -> None:
    empty = (None, MISSING, (), {}, "")
    said = [
        (at, one) for at, one in ALL if not any(one.default is e or one.default == e for e in empty)
    ]
    assert len(said) > 80
    for at, one in said:
        printed = keys._default(one, speaking("en"))
        assert printed[0] == printed[-1] == "`", (at, printed)
        for text in (
            printed.strip("`"),
            *(example_of(one, speaking(other)) for other in languages()),
        ):
            assert _taken(one, at, tomllib.loads(f"it = {text}")["it"]) == one.default, at


def test_a_default_of_the_schema_is_accepted() -> None:
    said = [(at, one, key_schema(at, one, {})) for at, one in ALL]
    for at, one, told in said:
        if "default" in told:
            assert _taken(one, at, told["default"]) == one.default, at


def test_an_example_is_accepted_as_it_is_printed() -> None:
    for language in languages():
        for at, one in ALL:
            if (printed := keys._written(one.example, speaking(language))) != keys.NONE:
                _taken(one, at, tomllib.loads(f"it = {printed.strip('`')}")["it"])


def test_all_positions_may_stand_in_a_list() -> None:
    one, other, some = (
        table(in_usual_size(understood(tomllib.loads(text), "scene")), "csv")
        for text in (SCENE, SCENE.replace('["all"]', '"all"'), SCENE.replace('["all"]', "[1]"))
    )
    assert one == other != some
