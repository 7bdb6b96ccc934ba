"""Golden tasks: the sheets of two tasks redraw to the committed bytes; --redraw accepts new ones."""

from __future__ import annotations

import pytest
from support.gallery import CASES, SHEETS

from graphic_tmm.classroom.batch.work import done
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.variant import base

pytestmark = pytest.mark.every

FOLDER = CASES / "tasks"


@pytest.mark.parametrize("name", ["shaper", "windrower"])
def test_a_task_redraws_to_the_committed_sheets(name: str, request: pytest.FixtureRequest) -> None:
    (work,) = works(base(SHEETS / name), (), keys=())
    texts = {one.rpartition("/")[2]: str(text) for one, text in done(work).files.items()}
    if request.config.getoption("--redraw"):
        FOLDER.mkdir(exist_ok=True)
        for stale in FOLDER.glob(f"{name}*.svg"):
            stale.unlink()
        for file, text in texts.items():
            (FOLDER / file).write_text(text, encoding="utf-8", newline="\n")
    assert {path.name for path in FOLDER.glob(f"{name}*.svg")} == set(texts)
    for file, text in texts.items():
        assert (FOLDER / file).read_bytes() == text.encode("utf-8"), file
