"""Signs of mark-up in verdicts and in texts of a scene: data until the file is written, escaped there once."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from support.scenes import source, written
from support.words import BLOCK, worded

from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.lettering.letters import (
    plain as lettered,
)
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

VERDICTS = {
    "forces beyond their limit": (
        "lever",
        ("[forces]", "[forces]\nlimit = 0.1"),
        {" > 0,1 %"},
    ),
    "a pair of gears that is undercut": ("gear-pair", ("x1 = 0.83", "x1 = 0.0"), {" < "}),
}


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("what", VERDICTS)
def test_a_verdict_is_lettered_as_it_is_meant(what: str, tmp_path: Path) -> None:
    """A sign of mark-up is a character like others until the file is written: there it is escaped once."""
    name, (old, new), signs = VERDICTS[what]
    text = source(name)
    assert old in text
    path = written(tmp_path, text.replace(old, new))
    papers = sheets(read(path))[1]
    labels = [label.text for paper in papers for view in paper.drawings for label in view.labels]
    assert not [text for text in labels if re.search("&[a-z]+;", text)]
    told = [text for text in labels if any(sign in text for sign in signs)]
    assert told, labels
    drawings = [svg(paper) for paper in papers]
    for drawing in drawings:
        assert not re.search("&amp;[a-z]+;", drawing)
    seen = [e.text for d in drawings for e in ElementTree.fromstring(d).iter() if e.text]
    assert set(map(lettered, told)) <= set(seen)


SIGNS = "< > & \" '"


NARROW = {"letter": "<", "scale": "<&>", "mass": "<&>"}
"""What has little room on the sheet gets signs that stand in it."""


@pytest.mark.turns(3)
@pytest.mark.parametrize("key", ["title", "name", *BLOCK])
def test_every_text_of_a_scene_reaches_every_file_as_it_is(key: str, tmp_path: Path) -> None:
    signs = NARROW.get(key, SIGNS)
    texts = {"title": "T", "name": "n", "designation": "d"} | {key: signs}
    papers = sheets(read(worded(tmp_path, "A1", "ru", **texts)))[1]
    labels = [label.text for paper in papers for view in paper.drawings for label in view.labels]
    read_back = [e.text for e in ElementTree.fromstring(svg(papers[0])).iter() if e.text]
    if key not in ("title", "name"):
        assert escape(signs) in labels
    assert signs in read_back
