"""What error of each length is seen, as a table on a terminal."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from graphic_tmm.checking.judging.power import SeenError
from graphic_tmm.checking.report.rows import plan_name, printable_text
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.said import said

HEADS = (
    said("plan", context="power"),
    said("segment", context="power"),
    said("seen in half, mm", context="power"),
    said("by position", context="power"),
    said("in 19 of 20, mm", context="power"),
)
SAYS = said(
    "So many mm by which one length is off are called wrong in half of the drawings, and in 19 of 20, where "
    "all lengths of the plans are given: the median of the positions, the least and the most of them."
)
NOTHING = said("No length of this scene is measured on a plan.")


def power_report(rows: Sequence[SeenError], language: str) -> list[Any]:
    """Return what rich prints of the errors that are seen."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table
    from rich.text import Text

    speech = speaking(language)
    if not rows:
        return [Text(speech(NOTHING))]
    table = Table(box=SIMPLE_HEAD, show_edge=False)
    for k, head in enumerate(HEADS):
        table.add_column(Text(speech(head)), justify="left" if k < 2 else "right")
    for one in rows:
        half, nearly, least, most = (
            fixed(mm, 1, language) for mm in (one.half, one.nearly, one.least, one.most)
        )
        names = plan_name(one.plan, language), printable_text(one.segment)
        table.add_row(*map(Text, (*names, half, f"{least} … {most}", nearly)))
    return [Text(speech(SAYS)), table]
