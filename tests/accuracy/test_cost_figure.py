"""The figure of an answer: its panels, the same bytes twice, nothing cut off, readable in grey."""

from __future__ import annotations

from dataclasses import replace
from io import BytesIO

import numpy as np
import pytest
from PIL import Image
from support.tasks import answered

from graphic_tmm.accuracy.answer import Answer
from graphic_tmm.accuracy.cost_figure import figures
from graphic_tmm.accuracy.machine_times import MachineTime
from graphic_tmm.accuracy.timing import Seconds

NAME = "slider-diagrams"
DPI, WIDE = 160, 4.8


def timed() -> Answer:
    """Return an answer with times that a clock of a test might have told."""
    own = answered(NAME)
    times = [
        MachineTime(what, n, Seconds(t * n, t * n, t * n, 1.1 * t * n))
        for what, t in (("log", 1e-4), ("table", 0.01), ("sheets", 0.02), ("drawings", 0.03))
        for n in own.counts
    ]
    return replace(own, machine=tuple(times))


def image(answer: Answer) -> Image.Image:
    return Image.open(BytesIO(figures(answer)["png"])).convert("L")


@pytest.mark.parametrize(("answer", "panels"), [(answered, 2), (lambda _: timed(), 3)])
@pytest.mark.slow
def test_there_is_a_panel_for_minutes_one_for_the_machine_if_timed_and_the_sources(
    answer: object, panels: int
) -> None:
    svg = figures(answer(NAME))["svg"].decode()  # type: ignore[operator]
    assert f'id="axes_{panels}"' in svg
    assert f'id="axes_{panels + 1}"' not in svg


def test_the_same_answer_gives_the_same_bytes_without_a_date() -> None:
    one, two = figures(answered(NAME)), figures(answered(NAME))
    assert one == two
    assert b"<dc:date>" not in one["svg"]


@pytest.mark.parametrize("language", ["ru", "en"])
def test_nothing_is_cut_off_at_the_margin(language: str) -> None:
    """Three columns and rows of pixels along each edge stay white."""
    own = timed()
    pixels = np.asarray(image(replace(own, scene=replace(own.scene, language=language))))
    assert pixels.shape[1] == round(DPI * WIDE)
    edges = (pixels[:3], pixels[-3:], pixels[:, :3], pixels[:, -3:])
    assert all((edge == 255).all() for edge in edges)


def test_sources_are_distinct_by_hatching_where_colours_are_not() -> None:
    svg = figures(answered(NAME))["svg"].decode()
    hatched = svg.count("<pattern")
    assert hatched >= 3


def test_a_drawing_without_any_error_is_drawn_too() -> None:
    own = answered(NAME)
    nothing = own.own._replace(errors=dict.fromkeys(own.own.errors, 0.0))
    assert figures(replace(own, own=nothing))["png"]
