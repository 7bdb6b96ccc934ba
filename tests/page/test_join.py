"""The modules of the page, joined: nothing of their code is lost, nothing but code is carried."""

from collections import Counter
from importlib.resources import files

from graphic_tmm.page.join import script

MODULES = [one for one in (files("graphic_tmm.page") / "web").iterdir() if one.name.endswith(".js")]


def test_every_line_of_code_is_carried():
    code: Counter[str] = Counter()
    for module in MODULES:
        lines = [
            line
            for line in module.read_text("utf-8").splitlines()
            if not line.startswith("import {")
        ]
        code.update(
            line.lstrip().removeprefix("export ") for line in lines if line and not _comment(line)
        )
    joined = Counter(line.removeprefix("export ") for line in script().splitlines() if line)
    assert joined == code


def test_no_text_goes_over_a_line():
    for module in MODULES:
        for line in module.read_text("utf-8").splitlines():
            assert line.count("`") % 2 == 0, line


def test_no_comment_is_carried():
    assert not [line for line in script().splitlines() if _comment(line)]


def _comment(line: str) -> bool:
    bare = line.strip()
    cast = bare.startswith("/**") and "*/ " in bare
    return not cast and (bare.startswith(("/**", "* ", "*/", "//")) or bare == "*")
