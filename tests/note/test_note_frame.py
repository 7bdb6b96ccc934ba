"""Pages of a note in frames, where its author wants them: form 2, then 2a, the text within."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pypdfium2
import pytest
from support.gallery import SHEETS

from graphic_tmm.note.note import note_files, wanted
from graphic_tmm.scene.author import Author
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

MM = 72.0 / 25.4
"""Points of a millimetre."""


def pages(*, frame: bool) -> pypdfium2.PdfDocument:
    scene = replace(
        read(SHEETS / "slider-diagrams"),
        language="ru",
        author=Author(frame=frame),
        title_block={"designation": "ТММ.01.00.000"},
    )
    (data,) = note_files(make(scene, wanted=wanted(scene)), "x", ["pdf"]).values()
    return pypdfium2.PdfDocument(data)


def dark(page: pypdfium2.PdfPage, x: float, low: float, high: float) -> bool:
    """Whether an upright line stands at x from low to high, mm from the lower left corner."""
    scale = 4.0
    image = np.asarray(page.render(scale=scale / MM).to_pil().convert("L"))
    tall = image.shape[0]
    strip = image[
        round(tall - high * scale) : round(tall - low * scale),
        round((x - 0.6) * scale) : round((x + 0.6) * scale),
    ]
    return bool((strip.min(axis=1) < 128).all())


@pytest.mark.slow
def test_pages_behind_the_title_page_have_frames_and_text_keeps_within_them() -> None:
    book = pages(frame=True)
    assert len(book) > 3
    assert not dark(book[0], 20.0, 6.0, 291.0)
    for k in range(1, len(book)):
        page, block = book[k], 40.0 if k == 1 else 15.0
        assert dark(page, 20.0, 6.0, 291.0)
        assert dark(page, 205.0, 6.0, 291.0)
        assert dark(page, 60.0, 5.5, 5.0 + block - 0.5)  # the column of signatures
        assert not dark(page, 60.0, 5.0 + block, 5.0 + block + 20.0)
        text = page.get_textpage()
        boxes = [text.get_charbox(n) for n in range(text.count_chars())]
        seen = [one for one in boxes if one[2] > one[0]]
        assert min(one[0] for one in seen) >= 25.0 * MM
        assert max(one[2] for one in seen) <= 202.0 * MM
        assert min(one[1] for one in seen) >= (5.0 + block + 5.0) * MM
    bare = pages(frame=False)
    assert not any(dark(bare[k], 20.0, 6.0, 291.0) for k in range(len(bare)))
