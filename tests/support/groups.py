"""Tests of one scene or part go to one worker, which draws it once; others go with those of their file."""

from __future__ import annotations

import re

from xdist.scheduler import LoadScopeScheduling

from support import gallery, parts

_LONGEST = sorted({*gallery.ALL, *parts.PARTS}, key=len, reverse=True)
_NAMED = re.compile(rf"(?:^|-)({'|'.join(map(re.escape, _LONGEST))})(?=-|$)")


TOGETHER = (
    ("tests/page/practice/",),
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
once, random mechanisms walked once, notes made once, the package's own text read once."""


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
