"""The protocol of the page: what the terminal prints, in headings and ordered steps."""

import pytest
from support.gallery import made

from graphic_tmm.page.sentences import protocol_of
from graphic_tmm.readers.protocol import plans, steps_of

WHY = {"en": "Why", "ru": "Почему"}


@pytest.mark.parametrize("scene", ["windrower", "cam"])
@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_page_tells_what_the_terminal_prints_in_the_same_order(scene, language):
    found = made(scene)
    told = []
    for plan in protocol_of(found, language):
        told.append(plan.title)
        for run in plan.runs:
            for line in run.lines:
                told.append(f"{line.label}. {line.text}" if run.numbered else f"[{line.text}]")
                told += [f"{WHY[language]}: {line.why}"] if line.why else []
                told += [line.calculation] if line.calculation else []
    printed = steps_of(found, plans(), None, language, why=True)
    assert told == [line.strip() for line in printed if line]
