"""A place by tracing paper and by the locus: accuracy tells both errors, and which is truer."""

from __future__ import annotations

from dataclasses import replace

import pytest
from support.tasks import answered

from graphic_tmm.accuracy.answer_text import costs


@pytest.mark.parametrize(
    ("errors", "told"),
    [
        (
            {"locus": 5.9, "tracing": 3.7, "v": 9.0},
            "by its locus 5.9 %; place of the plate by tracing paper 3.7 %. The truest: place of the plate by "
            "tracing paper.",
        ),
        ({"locus": 3.7, "tracing": 3.6, "v": 9.0}, "3.6 %. They are as true as each other."),
        ({"locus": 3.7, "v": 9.0}, ""),
    ],
)
def test_of_two_ways_both_errors_are_told_and_which_is_truer(
    errors: dict[str, float], told: str
) -> None:
    whole = answered("slider-diagrams")
    own = replace(
        whole,
        scene=replace(whole.scene, language="en"),
        own=whole.own._replace(errors=errors),
        printed=None,
    )
    found = [line for line in costs(own) if line.startswith("Drawn in several ways")]
    assert told in " ".join(found)
    assert bool(found) == bool(told)
    assert own.main == "v"  # what compares ways is not what it is made for
