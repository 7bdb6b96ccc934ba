"""The modules of the page, joined: nothing of their code is lost, nothing but code is carried."""

from collections import Counter
from importlib.resources import files
from pathlib import Path

import pytest

from graphic_tmm.errors import SheetError
from graphic_tmm.page import join
from graphic_tmm.page.join import modules_of, script, style

WEB = files("graphic_tmm.page") / "web"
TYPES = "export {};"
"""What a module of nothing but types says is no code."""
FURTHER = sorted(one.name for one in WEB.iterdir() if one.is_dir())


@pytest.mark.parametrize("further", [(), tuple(FURTHER)])
def test_every_line_of_code_is_carried(further):
    code: Counter[str] = Counter()
    for text in modules_of(*further).values():
        code.update(
            line.lstrip().removeprefix("export ")
            for line in text.splitlines()
            if line and line != TYPES and not line.startswith("import ") and not _comment(line)
        )
    joined = Counter(line.removeprefix("export ") for line in script(*further).splitlines() if line)
    assert joined == code


def test_no_text_goes_over_a_line():
    for text in modules_of(*FURTHER).values():
        for line in text.splitlines():
            assert line.count("`") % 2 == 0, line


def test_no_comment_is_carried():
    assert not [line for line in script(*FURTHER).splitlines() if _comment(line)]


@pytest.fixture
def web(tmp_path, monkeypatch):
    """A page of one module, with a folder that enters a way of looking and a module that nobody imports."""

    def written(name: str, *lines: str) -> None:
        file = tmp_path / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")

    written("main.js", 'import { ROOMS } from "./rooms.js";', "begin(ROOMS);")
    written("rooms.js", "export const ROOMS = {};")
    written("page.css", "p { margin: 0; }")
    written(
        "more/enter.js",
        'import { ROOMS } from "../rooms.js";',
        'import { made } from "./made.js";',
        "ROOMS.more = made;",
    )
    written("more/made.js", 'import "./told.js";', "export const made = 1;")
    written("more/told.js", "tell();")
    written("more/more.css", "p { padding: 0; }")
    monkeypatch.setattr(join, "_WEB", tmp_path)
    for kept in (script, style):
        monkeypatch.setattr(join, kept.__name__, kept.__wrapped__)
    return written


def test_a_page_has_only_what_it_was_asked_for(web):
    assert join.script() == "\nconst ROOMS = {};\nbegin(ROOMS);\n"
    assert "padding" not in join.style()


def test_a_folder_is_entered_before_the_page_begins(web):
    lines = join.script("more").split()
    assert lines.index("tell();") < lines.index("made;") < lines.index("begin(ROOMS);")
    text = join.style("more")
    assert text.index("margin: 0") < text.index("padding: 0")


def test_one_name_stands_once_in_all_folders(web):
    web("more/told.js", "const ROOMS = 1;")
    with pytest.raises(SheetError, match=r"ROOMS stands in (rooms|more/told)\.js and in"):
        join.script("more")


def test_the_real_folders_are_told_by_no_page_that_does_not_ask():
    inside = {name for name in modules_of(*FURTHER) if "/" in name}
    assert all(Path(name).parts[0] in FURTHER for name in inside)
    assert len(script()) <= len(script(*FURTHER))


def _comment(line: str) -> bool:
    bare = line.strip()
    cast = bare.startswith("/**") and "*/ " in bare
    return not cast and (bare.startswith(("/**", "* ", "*/", "//")) or bare == "*")
