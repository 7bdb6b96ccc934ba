"""No drive is called by the words of another: all that scenes of every drive say, read in both languages."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from support.words_of_drives import SCENES, amiss, told

KEYS = re.compile(r'"crank": \[\]')
"""What only code reads: that a page has no crank to be dragged."""


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", SCENES)
def test_a_drive_is_told_in_its_own_words(name: str, language: str, tmp_path: Path) -> None:
    scene = SCENES[name]
    wrong = [
        (where, pattern, text[max(0, found.start() - 60) : found.end() + 40])
        for where, text in told(scene, language, tmp_path)
        for pattern in amiss(scene)
        for found in re.finditer(pattern, KEYS.sub("", text))
    ]
    assert not wrong
