"""Text of a scene is text in every corner of its page, whatever it would mean elsewhere."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.lesson import walk
from support.words import worded

from graphic_tmm.page.page import page
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

HOSTILE = {
    "a script": "<script>document.title = 'hurt'</script>",
    "an end of a script": "</script></style></title></noscript><img src=x onerror=alert(1)>",
    "ends of other things": "]]> --> */ `${alert(1)}` \\u003c",
    "quotes": "\" onload=alert(1) x='y' `z` &quot; &amp;lt;",
    "braces": "{name} {{ title }} {% raw %} ${x}",
    "a prototype": "__proto__ constructor",
}


@pytest.mark.parametrize("some", [("a script", "quotes", "braces"), tuple(HOSTILE)[1::2]])
def test_text_of_a_scene_is_text_on_its_page(some: tuple[str, ...], opened, tmp_path: Path) -> None:
    text = " ".join(HOSTILE[what] for what in some)
    scene = worded(tmp_path, "A3", "en", title=text, name=text, designation=text, drawn_by=text)
    file = tmp_path / "page.html"
    file.write_text(page(*sheets(read(scene))), encoding="utf-8")
    tab = opened(file)
    tab.page.get_by_role("tab").first.wait_for()
    due = " ".join(text.split())
    shown = tab.page.get_by_role("heading", level=1).inner_text()
    assert " ".join(shown.split()) == due
    assert " ".join(tab.page.title().split()) == due
    assert tab.page.locator("img, iframe, object, embed, base, link, form").count() == 0
    assert tab.page.locator("script").count() <= 4
    (view, *_) = walk(tab.page, "en")
    assert view.pictures > 1
    for one in tab.page.get_by_role("tab").all():
        one.click()
    assert tab.settle() == []
