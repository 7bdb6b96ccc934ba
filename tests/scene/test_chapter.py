"""Chapters answer what readers ask in the file that the question names, and are imported no sooner."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from pkgutil import resolve_name, walk_packages
from typing import ClassVar

import pytest
from support.gallery import scene

from graphic_tmm.drawn import Findings
from graphic_tmm.scene.captions import Named
from graphic_tmm.scene.chapter import Answer, Chapter, chapters, places, whole_book
from graphic_tmm.scene.tasks import calls_for


def questions() -> Iterator[type[Answer]]:
    """What is asked by any room of the package."""
    whole_book()
    waiting = [Answer]
    while waiting:
        for kind in waiting.pop().__subclasses__():
            waiting.append(kind)
            if kind.__module__.startswith("graphic_tmm."):
                yield kind


def test_every_question_is_answered_by_a_chapter_of_the_book() -> None:
    silent = [
        kind.__name__
        for kind in questions()
        if not any(_stands(chapter, kind) for chapter in chapters())
    ]
    assert silent == []


def test_what_stands_where_an_answer_is_looked_for_is_one() -> None:
    for kind in questions():
        for chapter in chapters():
            answer = kind.of(chapter)
            assert type(answer) is kind
            assert (answer != kind()) == _stands(chapter, kind), (chapter.name, kind)


def _stands(chapter: Chapter, kind: type[Answer]) -> bool:
    file, _, name = kind.stands.partition(".")
    try:
        module = import_module(f"{chapter.folder}.{file}")
    except ModuleNotFoundError:
        return False
    return hasattr(module, name)


@dataclass(frozen=True)
class Weighed(Answer):
    """A question of nobody's."""

    stands: ClassVar[str] = "words.WORDS"
    kilograms: float = 7.0


def test_a_chapter_without_a_folder_gives_its_answers_with_it() -> None:
    bare = Chapter("bare", 99)
    assert Weighed.of(bare) == Weighed()
    assert Weighed.of(Chapter("heavy", 99, answers=(Named(), Weighed(8.0)))).kilograms == 8.0


def test_an_answer_to_another_question_is_refused() -> None:
    (kinematics,) = (one for one in chapters() if one.name == "kinematics")
    with pytest.raises(TypeError, match=r"kinematics\.words\.WORDS is no Weighed"):
        Weighed.of(kinematics)


def test_a_fault_in_a_chapters_file_is_no_missing_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    room = tmp_path / "a_broken_room"
    room.mkdir()
    (room / "__init__.py").write_text("", encoding="utf-8")
    (room / "findings.py").write_text("import nothing_of_that_name\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ModuleNotFoundError, match="nothing_of_that_name"):
        Findings.of(Chapter("broken", 99, folder=room.name))


@pytest.mark.parametrize("chapter", chapters(), ids=lambda one: one.name)
def test_every_answer_in_a_folder_is_found_by_its_question(chapter: Chapter) -> None:
    """A file that was renamed would be asked no more, and what holds without an answer would hold instead."""
    for _, name, _ in walk_packages(import_module(chapter.folder).__path__, f"{chapter.folder}."):
        for key, value in vars(import_module(name)).items():
            if isinstance(value, Answer):
                assert type(value).of(chapter) is value, f"{name}.{key}"


def test_every_refusal_of_a_section_is_a_function_that_is_there() -> None:
    named = [
        section.refuse for chapter in chapters() for section in chapter.sections if section.refuse
    ]
    assert len(named) >= 4
    assert all(callable(resolve_name(one)) for one in named)


def test_what_a_scene_calls_for_is_asked_for_by_a_section_or_by_its_mechanism() -> None:
    called = {one.name for one in chapters() if calls_for(scene("crank-rocker"), one)}
    # what balances by centres is there wherever centres and forces are
    assert called == {"structure", "kinematics", "advantage"}
    assert {one.name for one in chapters() if calls_for(scene("cam"), one)} == {"cam"}
    assert not any(calls_for(scene("lettering"), one) for one in chapters())


def test_chapters_are_known_before_what_they_draw_is_imported() -> None:
    """A command that only reads a scene pays for no plan and no ink."""
    code = (
        "import sys; from graphic_tmm.scene.chapter import chapters, places; chapters(); places();"
        "own = [m for m in sys.modules if m.startswith('graphic_tmm.chapters.')];"
        "late = ('plan', 'views', 'ink', 'note', 'table', 'task_sheet', 'words', 'record');"
        "print([m for m in own if m.rpartition('.')[2] in late],"
        " [m for m in sys.modules if m.startswith(('graphic_tmm.paper.', 'graphic_tmm.note'))])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["[]", "[]"]


def test_a_place_stands_once() -> None:
    assert len(places()) == sum(len(one.places) for one in chapters())
