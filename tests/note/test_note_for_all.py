"""A page of a note is for who sees little or nothing, too: the laws that checkers of pages hold, one by one.

WCAG 2.2, level AA, as far as it can be told from the page itself: language and title (2.4.2, 3.1.1), what is
not text (1.1.1), headings, lists, heads of tables (1.3.1), names of links (2.4.4), ids (4.1.1), contrast
(1.4.3, 1.4.11).
"""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise

import pytest
from lxml import html
from support.notes import file_of, noted

from graphic_tmm.note.styles import CSS

SCENES = [
    ("slider-diagrams", "ru"),
    ("slider-diagrams", "en"),
    ("lever", "ru"),
    *[
        pytest.param(name, "ru", marks=pytest.mark.slow)
        for name in ("engine", "locomobile", "project")
    ],
]
each_page = pytest.mark.parametrize(("name", "language"), SCENES)


@cache
def page(name: str, language: str) -> html.HtmlElement:
    return html.document_fromstring(file_of(name, "html", language).decode("utf-8"))


def words(element: html.HtmlElement) -> str:
    return " ".join(element.text_content().split())


@each_page
def test_the_page_says_what_it_is_and_in_which_language(name: str, language: str) -> None:
    root = page(name, language)
    assert root.get("lang") == language
    assert [words(one) for one in root.iter("title") if one.getparent().tag == "head"] == [
        noted(name, language).title
    ]
    assert len(root.findall(".//main")) == 1
    (view,) = root.xpath("//meta[@name='viewport']")
    assert "user-scalable" not in view.get("content")
    (contents,) = root.iter("nav")
    assert contents.get("aria-label")
    outside = [one.tag for one in root.find("body") if one.tag != "main"]
    assert not outside


@each_page
def test_headings_leave_out_no_level_and_are_never_empty(name: str, language: str) -> None:
    heads = list(page(name, language).iter("h1", "h2", "h3", "h4", "h5", "h6"))
    levels = [int(one.tag[1]) for one in heads]
    assert levels[0] == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    assert all(map(words, heads))


@each_page
def test_what_is_no_text_has_a_text(name: str, language: str) -> None:
    root = page(name, language)
    pictures = [one for one in root.iter("svg") if one.get("role") == "img"]
    assert len(pictures) == len(list(root.iter("svg"))) > 0
    for one in pictures:
        assert one.get("aria-label", "").strip()
        assert one.getparent().tag == "figure"
        (caption,) = one.getparent().findall("figcaption")
        assert words(caption)
    assert not list(root.iter("img", "video", "object", "iframe"))
    formulas = list(root.iter("math"))
    assert formulas
    assert all(one.find("semantics/annotation") is not None for one in formulas)


@each_page
def test_tables_have_heads_that_say_of_what(name: str, language: str) -> None:
    found = list(page(name, language).iter("table"))
    plain = [one for one in found if one.get("role") == "presentation"]
    assert [one.get("id") for one in plain] == ["people"]
    for table in found:
        heads = list(table.iter("th"))
        if table in plain:
            assert not heads
            assert table.find("caption") is None
            continue
        assert words(table.find("caption"))
        above = table.findall("thead/tr/th")
        assert above
        assert {one.get("scope") for one in above} == {"col"}
        assert {one.get("scope") for one in heads if one not in above} <= {"row"}
        told = [words(one) or one.find(".//math") is not None for one in above]
        assert all(told), table.get("id")
        wide = {sum(int(c.get("colspan", 1)) for c in row) for row in table.iter("tr")}
        assert wide == {len(above)}


@each_page
def test_links_are_told_and_lead_somewhere_and_no_id_stands_twice(name: str, language: str) -> None:
    root = page(name, language)
    ids = [one.get("id") for one in root.iter() if one.get("id")]
    assert len(set(ids)) == len(ids)
    for link in root.iter("a"):
        assert words(link)
        assert link.get("href", "").removeprefix("#") in ids


@each_page
def test_lists_hold_items_only(name: str, language: str) -> None:
    for one in page(name, language).iter("ul", "ol"):
        assert {item.tag for item in one} == {"li"}


COLOURS = {"white": "#ffffff", "black": "#000000"}


def luminance(colour: str) -> float:
    """The relative luminance of a colour, WCAG 2.2."""
    told = COLOURS.get(colour, colour).removeprefix("#")
    told = "".join(c * 2 for c in told) if len(told) == 3 else told
    parts = [int(told[k : k + 2], 16) / 255 for k in (0, 2, 4)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(first: str, second: str) -> float:
    low, high = sorted((luminance(first), luminance(second)))
    return (high + 0.05) / (low + 0.05)


def test_the_measure_of_contrast_is_that_of_the_standard() -> None:
    assert contrast("black", "white") == pytest.approx(21.0)
    assert contrast("#777", "#fff") == pytest.approx(4.48, abs=0.01)


def test_letters_stand_out_from_the_page() -> None:
    (ground,) = re.findall(r"background: (#\w+)", CSS)
    letters = re.findall(r"[{; ]color: (#\w+)", CSS)
    assert len(letters) == 2  # of text, of links
    assert all(contrast(one, ground) >= 4.5 for one in letters)
    edges = re.findall(r"border: 1px solid (#\w+)", CSS)
    assert edges
    assert all(contrast(one, ground) >= 3.0 for one in edges)


@each_page
def test_lines_of_figures_stand_out_from_their_paper(name: str, language: str) -> None:
    root = page(name, language)
    inks = {one.get(key) for one in root.iter() for key in ("stroke", "fill") if one.get(key)}
    inks -= {"none", "white"}
    assert inks
    assert all(contrast(one, "white") >= 3.0 for one in inks), inks
