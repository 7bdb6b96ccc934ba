"""Tests of one scene or part go to one worker, which draws it once; others go with those of their file."""

from __future__ import annotations

import re

from xdist.scheduler import LoadScopeScheduling

from support import gallery, parts

_LONGEST = sorted({*gallery.ALL, *parts.PARTS}, key=len, reverse=True)
_NAMED = re.compile(rf"(?:^|-)({'|'.join(map(re.escape, _LONGEST))})(?=-|$)")

SHARED = {
    "windrower": "page/browser/test_everybody page/browser/test_lecture page/browser/test_page_sheets "
    "page/browser/test_play",
    "crank-rocker": "page/browser/test_beside_practice page/browser/test_changed_lengths "
    "page/browser/test_own_drawing page/browser/test_page_crank page/browser/test_practice",
    "slider-diagrams": "accuracy/test_answer_text accuracy/test_cost_figure accuracy/test_note_section "
    "page/browser/test_accuracy_room page/test_error_shares",
}
"""Scenes, and files whose tests have them without naming them: a page or an answer of what accuracy costs takes
seconds."""
TOGETHER = (
    ("tests/page/practice/",),
    *((scene, *(f"tests/{name}.py" for name in names.split())) for scene, names in SHARED.items()),
    ("tests/judges/test_random_drive",),
    ("tests/note/",),
    (
        "tests/test_roles",
        "tests/test_views_have_roles",
        "tests/test_chapter_names",
        "tests/test_plain_names",
        "tests/language/",
    ),
)
"""Beginnings of names of files whose tests share what takes longer than they do: the tasks of all scenes worked
once, pages written once, random mechanisms walked once, notes made once, the package's own text read once. The
first names the group: a scene, where they share that with its other tests."""


def group_of(test: str) -> str:
    """Return the scene or part that a test names in its brackets; of one that names none, its file."""
    if shared := next(filter(test.startswith, TOGETHER), ()):
        return shared[0]
    found = _NAMED.search(test.partition("[")[2].removesuffix("]"))
    return test.partition("::")[0] if found is None else found[1]


class ByScene(LoadScopeScheduling):
    """Workers are given a scene, all of its tests one after another, or a file."""

    def _split_scope(self, nodeid: str) -> str:
        return group_of(nodeid)
