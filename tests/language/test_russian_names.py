"""Russian sheets, tables and protocols write J_пр, R^τ and с⁻¹, never the letters of the log for them."""

from __future__ import annotations

import re

import pytest
from support.command import printed
from support.gallery import paper

from graphic_tmm.paper.lettering.letters import plain

FOREIGN = re.compile(r"J_r\b|J_red|Jᵣ|\^t\b|(?<!_)1/[сs]|\brad\b")


def test_the_rule_finds_what_was_written_before() -> None:
    for text in ("J_r", "R₁₂^t", "μ_ω = 4 (1/с)/мм", "II(4-5): a_D = a_C + a_DC^t", "1/с²"):
        assert FOREIGN.search(text)
    for text in ("J_пр", "R₁₂^τ", "с⁻¹/мм", "a_DC^τ", "T_3пост", "a_3t"):
        assert not FOREIGN.search(text)


@pytest.mark.parametrize("name", ["windrower", "planetary", "slider-diagrams"])
def test_sheets_tables_and_protocols_are_free_of_them(name: str) -> None:
    made, papers = paper(name)
    assert made.scene.language == "ru"
    for sheet in papers:
        for view in sheet.drawings:
            for text in (plain(label.text) for label in view.labels):
                assert not FOREIGN.search(text), (view.name, text)
    for command in ("table", "steps"):
        for row in printed(command, name).splitlines():
            assert not FOREIGN.search(row), row
