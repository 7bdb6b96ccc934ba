"""One declaration of a section is its reader, its schema, its page in the reference and the record of plans."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from graphic_tmm.board.bounds import Bound
from graphic_tmm.errors import SceneError
from graphic_tmm.scene import keys
from graphic_tmm.scene import values as v
from graphic_tmm.scene.chapter import Chapter, added
from graphic_tmm.scene.declare import Flaw, Said, Section, combined_key, key, keys_of
from graphic_tmm.scene.new import schema
from graphic_tmm.scene.read import read
from graphic_tmm.scene.registry import size_keys
from graphic_tmm.scene.sections import Parts, declared
from graphic_tmm.scene.tasks import SectionKey

HEAD = 'title = "T"\nlanguage = "en"\n[[sheet]]\nplace = ["lettering"]\n'


@dataclass(frozen=True)
class Coil:
    """A helical spring."""

    coils: int = key(v.number(Bound(2, 40, whole=True)), "its coils", 8)
    ends: tuple[float, float] = combined_key(
        lambda said: (said.free, said.loaded),
        free=key(v.POSITIVE_LENGTH, "its free length", "60 mm"),
        loaded=key(v.POSITIVE_LENGTH, "its length under load", "40 mm", 0.01, fixes="size"),
    )
    set_by_a_program: int = 3


def _check(said: Said, parts: Parts) -> Iterator[Flaw]:
    if said.loaded > said.free:
        yield Flaw(("coil", "loaded"), "a load shortens it; write a shorter length")


ASKED: SectionKey[Coil] = SectionKey("coil")
CHAPTER = Chapter(
    name="springs",
    number=99,
    board="springs",
    sections=(Section("coil", Coil, "a coil", alone=True, check=_check),),
)


@pytest.fixture(autouse=True)
def springs() -> Iterator[None]:
    with added(CHAPTER):
        yield


def _read(folder: Path, text: str) -> Any:
    path = folder / "scene.toml"
    path.write_text(HEAD + text, encoding="utf-8")
    return read(path)


def test_a_section_declared_elsewhere_is_read_as_its_record(tmp_path: Path) -> None:
    scene = _read(tmp_path, '[coil]\ncoils = 9\nfree = "60 mm"\n')
    assert ASKED.of(scene) == Coil(9, (0.06, 0.01))
    assert scene.told["coil.free"] == 7
    assert ASKED.of(ASKED.put(scene, None)) is None


def test_all_its_faults_are_told_at_once_with_their_lines(tmp_path: Path) -> None:
    with pytest.raises(SceneError) as caught:
        _read(tmp_path, '[coil]\ncoils = 1\nfree = "60 kg"\nlaoded = 1\nset_by_a_program = 4\n')
    told = {(fault.key, fault.line): fault.message for fault in caught.value.faults}
    assert "a whole number 2 to 40 is wanted" in told["coil.coils", 6]
    assert "a length is wanted" in told["coil.free", 7]
    assert 'did you mean "loaded"' in told["coil.laoded", 8]
    assert "means nothing here" in told["coil.set_by_a_program", 9]
    assert len(told) == 4
    with pytest.raises(SceneError, match=r"scene.toml:7: coil.loaded: a load shortens it"):
        _read(tmp_path, '[coil]\ncoils = 3\nloaded = "70 mm"\nfree = "60 mm"\n')
    with pytest.raises(SceneError, match='"coils" is missing; write for example coils = 8'):
        _read(tmp_path, '[coil]\nfree = "60 mm"\n')


def test_the_schema_and_the_reference_tell_it() -> None:
    told = schema()["$defs"]["CoilTable"]
    assert told["required"] == ["coils", "free"]
    assert told["properties"]["coils"]["maximum"] == 40
    assert told["properties"]["loaded"]["default"] == 0.01
    assert (
        "| `coils` | its coils | a whole number 2 to 40 | **to be written** | `8` |"
        in keys.reference()
    )
    assert "coil.loaded" in size_keys()


@pytest.mark.parametrize(("language", "suffix"), [("en", ".md"), ("ru", ".ru.md")])
def test_the_pages_of_keys_are_up_to_date(language: str, suffix: str) -> None:
    kept = Path(keys.__file__).with_suffix(suffix).read_text(encoding="utf-8")
    told = keys.reference(language)
    printed = re.sub(r"## `\[coil\]`\n.*?(?=## )", "", told, flags=re.DOTALL)
    assert kept == printed


def test_every_key_says_what_it_is_and_its_example_can_be_read() -> None:
    for name, section in declared().items():
        for other, one in keys_of(section.record).items():
            if name == "title_block":
                continue
            assert one.says, (name, other)
            if one.example is not None:
                found: list[Flaw] = []
                one.kind.understood(one.example, (name, other), {}, found)
                assert not found, found
