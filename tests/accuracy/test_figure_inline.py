"""The figure within a page: no styles, no ids but those that are used, short, letters where they were."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from graphic_tmm.accuracy.figure_inline import inline

DRAWN = """<?xml version="1.0"?>
<svg xmlns:xlink="http://www.w3.org/1999/xlink" width="144pt" height="72.5pt" viewBox="0 0 144 72.5"
 xmlns="http://www.w3.org/2000/svg" version="1.1">
 <metadata>of nothing</metadata>
 <defs>
  <style type="text/css">*{stroke-linejoin: round}</style>
 </defs>
 <g id="axes_1">
  <!-- 1.23456 -->
  <defs>
   <path id="a-31" d="M 0 1.23456
L 2 3
" style="stroke: #000000; fill: #ffffff; stroke-width: 0.8"/>
  </defs>
  <g transform="translate(12.3456 7) scale(0.085 -0.085)"><use xlink:href="#a-31"/></g>
  <text style="text-anchor: end" x="-0.004">style="fill: 1.23456"</text>
 </g>
</svg>
"""


def test_what_a_page_refuses_or_does_not_need_is_gone() -> None:
    figure = inline(DRAWN)
    assert (round(figure.width, 1), round(figure.height, 1)) == (50.8, 25.6)
    root = ElementTree.fromstring(figure.svg)
    parts = list(root.iter())
    assert not [
        one for one in parts if one.tag.endswith(("style", "metadata")) or "style" in one.attrib
    ]
    assert [one.get("id") for one in parts if one.get("id")] == ["a-31"]
    (path,) = (one for one in parts if one.tag.endswith("path"))
    assert (path.get("stroke"), path.get("fill"), path.get("d")) == (
        "black",
        "white",
        "M 0 1.23 L 2 3 ",
    )
    assert re.search(r"translate\(12\.35 7\) scale\(0\.085 -0\.085\)", figure.svg)


def test_text_stays_as_it_is_written() -> None:
    """A title may hold what looks like a style or a long number."""
    text = ElementTree.fromstring(inline(DRAWN).svg).find(".//{*}text")
    assert text is not None
    assert text.text == 'style="fill: 1.23456"'
    assert text.get("text-anchor") == "end"
