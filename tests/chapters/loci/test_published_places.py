"""The six published places of a 3-RPR platform, found by the locus of a pin as its sheet draws it."""

from __future__ import annotations

import numpy as np
from support.boards import usual_part
from support.gallery import SHEETS
from support.published_plates import SIX_PLACES, pins

from graphic_tmm.chapters.loci.record import LOCI_PLAN
from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.scene.read import read

NEAR = 0.01
"""Of the size that is drawn: so far a curve through 36 points may be off its locus."""


def test_the_locus_of_a_pin_finds_all_six_published_places() -> None:
    drawn = usual_part(LOCI, read(SHEETS / "planar-platform" / "scene.toml"))
    made = LOCI_PLAN.on(drawn)
    scale = 10 * drawn.value(made.mu)
    found = [[complex(drawn.reading[pin].flat[0]) * scale for pin in one] for one in made.places]
    off = np.array(
        [[np.abs(np.array(one) - pins(*due)).max() for one in found] for due in SIX_PLACES]
    )
    print(f"off by {np.nanmin(off, axis=1) / (10 * made.size)} of the size")
    assert sorted(np.nanargmin(off, axis=1)) == list(range(len(SIX_PLACES)))
    assert np.nanmin(off, axis=1).max() < NEAR * 10 * made.size
