"""A scene to begin with: every mechanism that is offered is read, drawn, and nothing of it is warned of."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest
from support.boards import in_usual_size
from support.command import invoke

from graphic_tmm.commands import new as command
from graphic_tmm.commands.new import BEGINNINGS
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.declare import MISSING, Kind, keys_of
from graphic_tmm.scene.new import MANNER, SCHEMA, example_of
from graphic_tmm.scene.packaged import packaged
from graphic_tmm.scene.read import read
from graphic_tmm.scene.sections import declared

NAMES = [one.name for one in BEGINNINGS]
EVERYDAY = ("swinging-cylinder", "planetary")
LARGE = ("rocker-by-task", "six-link")


def begun(folder: Path, name: str, language: str = "en") -> Path:
    done = invoke("new", folder / name, name, "-l", language)
    assert done.exit_code == 0, done.output
    assert done.stderr == ""
    return folder / name / "scene.toml"


def commented(text: str) -> list[str]:
    """Return the sections that stand in a scene as comments, without the signs of comments."""
    found = re.findall(r"(?m)(?:^# \[.*\n)(?:^# .*\n)*", text)
    return [re.sub("(?m)^# ", "", part) for part in found]


def test_every_mechanism_is_taken_from_a_scene_of_the_package() -> None:
    assert len(set(NAMES)) == len(NAMES) >= 14
    assert {one.scene for one in BEGINNINGS} <= {path.name for path in packaged()}


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", NAMES)
def test_every_mechanism_is_read_and_tells_all_that_may_be_added(
    name: str, language: str, tmp_path: Path
) -> None:
    file = begun(tmp_path, name, language)
    scene, text = read(file), file.read_text(encoding="utf-8")
    assert scene.language == language
    assert not scene.remarks
    there = tomllib.loads(text)
    assert there.keys() & set(MANNER) == {"sheet"}
    others = [re.match(r"\[+(\w+)", part)[1] for part in commented(text)]  # type: ignore[index]
    assert set(others) | there.keys() >= declared().keys() - {"frame", "link", "drive", "plans"}
    assert set(others) & there.keys() == {"sheet"}  # a further one
    first = text.splitlines()[0]
    assert first == f"#:schema {SCHEMA}"
    assert (file.parent / SCHEMA).exists()


def test_a_section_in_comments_is_one_when_the_signs_are_taken_away(tmp_path: Path) -> None:
    """Each is TOML; a default that is shown is read back to the default itself."""
    parts = commented(begun(tmp_path, "four-bar").read_text(encoding="utf-8"))
    assert len(parts) > 12
    asked = defaults = 0
    for part in parts:
        ((name, values),) = tomllib.loads(part).items()
        section = declared()[name]
        for key, value in (values[0] if section.several else values).items():
            one = keys_of(section.record)[key]
            default = one.default
            if (
                default in (MISSING, None)
                or default in ((), {}, "")
                or not isinstance(one.kind, Kind)
            ):
                continue
            assert example_of(one, speaking("en")) is not None
            defaults += one.kind.understood(value, (), {}, []) == default
            asked += 1
    assert asked > 40
    assert defaults == asked


@pytest.mark.turns(3)
@pytest.mark.parametrize(
    "name",
    [n if n in EVERYDAY else pytest.param(n, marks=pytest.mark.slow) for n in NAMES],
)
def test_every_mechanism_is_drawn_without_a_warning(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """In one language each, by turns; those of many sheets are composed onto them when measured only."""
    language = ("ru", "en")[NAMES.index(name) % 2]
    file = begun(tmp_path, name, language)
    if name in LARGE and not many(1, 0):
        assert in_usual_size(read(file)).boards
        return
    done = invoke("draw", file, "-o", tmp_path / "out")
    assert done.exit_code == 0, done.output
    # what the positions of the machine that it is taken from cost is said, and nothing else
    assert all(re.search("360 (positions|положениям)", line) for line in done.stderr.splitlines())
    assert list((tmp_path / "out").glob("*.svg"))


@pytest.mark.parametrize(("language", "told"), [("en", "Scotch"), ("ru", "кривошип")])
def test_mechanisms_are_listed_a_line_each(language: str, told: str) -> None:
    done = invoke("new", "--list", "-l", language)
    assert done.exit_code == 0
    lines = done.stdout.splitlines()
    assert [line.split()[0] for line in lines] == NAMES
    assert all(len(line) < 100 for line in lines)
    assert language == "en" or all(re.search("[а-я]", line) for line in lines), told


def test_a_terminal_is_asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from click.testing import CliRunner

    from graphic_tmm.__main__ import main

    monkeypatch.setattr(command, "_on_terminal", lambda: True)
    asked = CliRunner().invoke(
        main, ["new", str(tmp_path / "mine"), "-l", "en"], input="lathe\ntoggle\n"
    )
    assert asked.exit_code == 0, asked.output
    assert "Which mechanism?" in asked.stderr
    assert "planetary train 2K–H" in asked.stderr
    assert read(tmp_path / "mine").title == "Toggle press"


def test_without_a_mechanism_or_a_terminal_the_default_scene_is_copied(tmp_path: Path) -> None:
    done = invoke("new", tmp_path / "mine")
    assert done.exit_code == 0, done.output
    assert "[task]" in (tmp_path / "mine" / "scene.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ((), "--list"),
        (("mine", "lathe"), "slider-crank"),
        (("mine", "cam", "--like", "cam"), "leave the MECHANISM out"),
    ],
)
def test_what_is_asked_wrongly_is_refused(
    words: tuple[str, ...], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = invoke("new", *words, "-l", "en")
    assert done.exit_code == 2
    assert says in done.stderr
    assert not list(tmp_path.iterdir())


def test_a_scene_is_never_written_over(tmp_path: Path) -> None:
    file = begun(tmp_path, "toggle")
    before = file.read_bytes()
    done = invoke("new", file.parent, "cam", "-l", "en")
    assert done.exit_code == 2
    assert "it exists already" in done.stderr
    assert file.read_bytes() == before
