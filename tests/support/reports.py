"""Reports to be told: the engine's published readings, readings with any text in them."""

from __future__ import annotations

import io
import json
import math
from typing import Any

from rich.console import Console

from graphic_tmm.checking.records import (
    DOUBTFUL,
    FINE,
    WRONG,
    Judged,
    Lesson,
    Likely,
    Report,
    Taken,
)
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.checking.report.text import text_report

LANGUAGES = ("ru", "en")
HOSTILE = [
    "<script>alert(1)</script>",
    "</title></style><svg onload=x>",
    "a & b &lt; &#60; &amp;",
    "\"' onmouseover='x'",
    "a|b||c\\|d\\",
    "`code` *b* _i_ ~~s~~ [x](http://e.org) ![i](j) <http://e.org> http://e.org www.e.org",
    "# head",
    "1. one",
    "- item",
    "--- \n\n***",
    "\x1b[31mred\x1b]0;x\a\x9b2J",
    "\x00\x7f\u202egnp.exe\u2028\udcff",
    "[red]r[/red] :smile: {0} {title} %s $x$",
    "Ж" * 500,
    "",
]
# the document's table (A2): published readings; what they ought to be follows from r, l and ω
PUBLISHED = {
    "pb": [0, 44, 65, 60, 39, 17, 0, 17, 39, 60, 65, 44],
    "ps2": [40, 49, 60, 60, 51, 44, 40, 44, 51, 60, 60, 49],
    "ab": [60, 52, 31, 0, 31, 52, 60, 52, 31, 0, 31, 52],
}


def due(segment: str, k: int) -> float:
    """Return a segment of the engine's velocity plan by the vector loop, mm; pa = OA = 60 mm, AB = 128 mm."""
    r, rod, phi = 60.0, 128.0, math.radians(30 * k)
    beam = math.sqrt(rod * rod - (r * math.sin(phi)) ** 2)
    turn = -r * math.cos(phi) / beam  # of the rod, for a crank of ω = 1
    a = complex(-r * math.sin(phi), r * math.cos(phi))
    ab = turn * complex(r * math.sin(phi), beam)
    return abs({"pb": a + ab, "ps2": a + 44 / 128 * ab, "ab": ab}[segment])


def judged(segment: str = "pb", position: str = "1", found: float = 17.0, **more: Any) -> Judged:
    taken = Taken("velocities", position, segment, mm=found, line=more.pop("line", 2))
    at = {"due": 17.47, "percent": 0.7, "quantile": 0.6, "verdict": FINE} | more
    return Judged(taken, found, deviation=found - at["due"], **at)


def report(*readings: Judged, language: str = "en", mistakes: Any = (), notes: Any = ()) -> Report:
    return Report("engine", "Engine", language, "student", readings, tuple(mistakes), tuple(notes))


def engine(language: str = "en") -> Report:
    """The published readings of the engine, judged by shares of the plan alone."""
    longest = max(due(s, k) for s in PUBLISHED for k in range(12))
    made = []
    for segment, row in PUBLISHED.items():
        for k, mm in enumerate(row):
            off = abs(mm - due(segment, k)) / longest * 100
            verdict = FINE if off < 2.5 else DOUBTFUL
            more = {"due": due(segment, k), "percent": off, "verdict": verdict}
            made.append(judged(segment, str(k + 1), float(mm), line=len(made) + 2, **more))
    return report(*made, language=language)


def hostile(text: str, language: str = "en") -> Report:
    """A report that has one text wherever the text of others can stand."""
    taken = Taken(text, text, text, value=1.0, unit=text, line=2)
    bad = Judged(taken, 1.0, 2.0, -1.0, 50.0, 0.0, WRONG, unit=text, step=text, own=-1.0)
    more = (bad, bad._replace(taken=taken._replace(line=3), verdict=FINE))
    doubted = bad._replace(taken=taken._replace(line=4), verdict=DOUBTFUL)
    mistake = Likely(text, text, (2,), 1, 0.1, (text, text), family=text, chance=0.7)
    second = mistake._replace(
        lines=(3,), like=(), plan=text, segment=text, position=text, step=text
    )
    lesson = Lesson(text, text, text, text, text, text, text, True, bad, drawn=(text,))
    found, notes = (mistake, second), (text,)
    return Report(text, text, language, text, (*more, doubted), found, notes, (lesson,))


def explaining(*lines: int, name: str = "ω/r for ω·r", like: tuple[str, ...] = ()) -> Likely:
    return Likely(name, "the speed was divided", lines, 3, 0.04, like)


def loaded(text: str) -> dict[str, Any]:
    def refuse(name: str) -> None:
        raise AssertionError(name)

    return dict(json.loads(text, parse_constant=refuse))


def printed(made: Report, width: int, *, colours: bool = False) -> str:
    out = io.StringIO()
    console = Console(
        file=out, width=width, force_terminal=colours, color_system="truecolor" if colours else None
    )
    for part in text_report(made):
        console.print(part)
    return out.getvalue()


FORMS = [markdown_report, html_report, json_report, lambda made: printed(made, 100)]
"""Every form of a report."""
