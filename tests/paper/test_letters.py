"""The lettering: every character of the field, the grid of ГОСТ 2.304 type B, indices, the path."""

from __future__ import annotations

import itertools
import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.alphabet import ALL, DIGITS, LATIN, RUSSIAN, SPACES, upright
from support.each import each

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.lettering.glyphs import (
    BLANKS,
    SLANT,
    centre,
    characters,
    extremes,
    glyph,
    lean,
    parse,
)
from graphic_tmm.paper.lettering.letters import (
    SIZES,
    Lettering,
    compose,
    escape,
    letter,
    missing,
    svg_path,
    width,
)

CAPITAL_WIDTHS = {5: "ГЕЁЗС", 7: "АДМХЫЮ", 8: "ЖФШЩЪ", 6: "БВИЙКЛНОПРТУЦЧЬЭЯ"}
SMALL_WIDTHS = {6: "мъыю", 7: "жтфшщ", 4: "зс", 5: "абвгдеёийклнопрухцчьэя"}
DIGIT_WIDTHS = {3: "1", 6: "4", 5: "02356789"}
RISERS, TAILS = "бвф", "дрфуцщ"


def ink(character: str, *, inclined: bool = False) -> tuple[float, float, float, float]:
    """Left, lower, right and upper edge of a character's ink in units of h/10."""
    written = letter(escape(character), size=10.0, inclined=inclined)
    return (written.left, -written.descent, written.right, written.ascent)


def test_every_character_of_the_field_has_a_glyph() -> None:
    assert missing(ALL) == ""
    for character in set(ALL) - set(SPACES):
        assert upright(escape(character)).strokes, character


def test_missing_characters_are_told_once_and_sorted() -> None:
    assert missing("A漢щ語漢\t") == "\t漢語"
    assert missing("") == ""


def test_missing_character_is_refused_by_name() -> None:
    with pytest.raises(SheetError, match=r"'漢' \(U\+6F22\)"):
        letter("v_{漢}")


@each("size", SIZES)
@each("table", [CAPITAL_WIDTHS, SMALL_WIDTHS, DIGIT_WIDTHS])
def test_widths_of_the_standard(size: float, table: dict[int, str]) -> None:
    for units, row in table.items():
        for character in row:
            assert width(character, size=size) == pytest.approx(units * size / 10, abs=0.01)
            left, _, right, _ = ink(character)
            assert (left, right) == pytest.approx((0.0, units), abs=0.01), character


def test_the_tables_of_widths_are_the_whole_alphabet() -> None:
    assert sorted("".join(CAPITAL_WIDTHS.values())) == sorted(RUSSIAN)
    assert sorted("".join(SMALL_WIDTHS.values())) == sorted(RUSSIAN.lower())
    assert sorted("".join(DIGIT_WIDTHS.values())) == sorted(DIGITS)


def test_heights_of_capitals_and_digits() -> None:
    for character in RUSSIAN + LATIN + "ΓΔΘΛΞΠΣΦΨΩ" + DIGITS:
        _, low, _, high = ink(character)
        if character not in "ЁЙ":
            assert high == pytest.approx(10.0, abs=0.01), character
        if character not in "ДЦЩQ":
            assert low == pytest.approx(0.0, abs=0.01), character
    assert all(10.5 < ink(c)[3] <= 13.0 for c in "ЁЙ")
    assert all(-3.0 <= ink(c)[1] < 0.0 for c in "ДЦЩQ")


def test_heights_of_small_letters() -> None:
    for character in RUSSIAN.lower():
        _, low, _, high = ink(character)
        if character in RISERS:
            assert high == pytest.approx(10.0, abs=0.01), character
        elif character not in "ёй":
            assert high == pytest.approx(7.0, abs=0.01), character
        assert (low < -1.0) == (character in TAILS), character
        if character not in TAILS:
            assert low == pytest.approx(0.0, abs=0.01), character
    assert all(ink(c)[1] == pytest.approx(-3.0, abs=0.01) for c in "дрфуgjpqyβγζημξρφϕχψ")
    assert all(ink(c)[3] == pytest.approx(10.0, abs=0.01) for c in "bdfhklβδζθϑλξϕψ")


def test_strokes_stay_in_their_boxes() -> None:
    for character in sorted(characters() - set(BLANKS)):
        shape = glyph(character)
        x0, y0, x1, y1 = extremes(shape.strokes)
        assert x0 >= 0.5 - 1e-3, character
        assert x1 <= shape.width - 0.5 + 1e-3, character
        assert y0 >= -3.0, character
        assert y1 <= 13.0, character


def test_glyphs_are_made_of_lines_and_arcs_that_move() -> None:
    for character in characters():
        for stroke in (*glyph(character).strokes, *lean(glyph(character).strokes)):
            assert len(stroke) >= 2, character
            assert stroke[-1][2] == 0.0
            assert all(abs(bulge) <= 1.0 + 1e-9 for _, _, bulge in stroke)
            for a, b in itertools.pairwise(stroke):
                assert math.dist(a[:2], b[:2]) > 1e-3, character


def test_look_alikes_are_drawn_apart() -> None:
    for row in ("0ОоΘθ", "1lIι|", "3Зз", "vνγ", "uμυ", "xχ×", "aα", "wω", "pρ", "kк", "oσ"):
        drawn = [upright(escape(c)).strokes for c in row]
        assert len(set(drawn)) == len(row), row


@pytest.mark.parametrize("pair", ["НН", "ОН", "нн", "нН", "П1", "Hn", "HH"])
def test_gap_between_letters(pair: str) -> None:
    first, second = pair[0], pair[1]
    whole = upright(pair, 5.0)
    second_left = whole.parts[1][0] - 0.25
    assert second_left - width(first) == pytest.approx(1.0, abs=1e-9)
    assert whole.width == pytest.approx(width(first) + 1.0 + width(second), abs=1e-9)


def test_gap_between_words() -> None:
    assert width("Н Н") - 2 * width("Н") == pytest.approx(3.0, abs=1e-9)
    assert width("Н\u00a0Н") == width("Н Н")
    assert width("1\u202f000") < width("1 000")
    assert width("1\u2009000") > width("1000")


@given(st.text(alphabet=ALL, max_size=12), st.sampled_from(SIZES))
def test_the_ink_of_upright_text_is_within_its_width(text: str, size: float) -> None:
    written = upright(escape(text), size)
    if written.strokes:
        assert written.left >= -1e-3 * size
        assert written.right <= written.width + 1e-3 * size
    assert written.pen == pytest.approx(size / 10)
    assert written.size == size


def test_empty_text_and_spaces() -> None:
    assert letter("").strokes == ()
    assert letter("").width == letter("").ascent == letter("").descent == 0.0
    assert letter(" ").width == pytest.approx(1.0)
    assert svg_path(letter(" "), 3.0, 4.0) == ""


def test_inclined_letters_lean_by_15_degrees() -> None:
    (stem,) = letter("I", size=10.0).strokes
    run, rise = stem[1][0] - stem[0][0], stem[1][1] - stem[0][1]
    assert math.degrees(math.atan2(rise, run)) == pytest.approx(75.0)
    for character in "ОЮфS∫8":
        plumb, leaning = glyph(character).strokes, lean(glyph(character).strokes)
        for before, after in zip(plumb, leaning, strict=True):
            ends = [(x + SLANT * y, y) for x, y, _ in before]
            places = [vertex[:2] for vertex in after]
            assert all(min(math.dist(end, p) for p in places) < 1e-9 for end in ends), character


@pytest.mark.parametrize("text", ["Н_А", r"\u{v}", r"\bar{v}^2"])
def test_indices_and_lines_lean_with_their_line(text: str) -> None:
    for (x, y, _), (lx, ly, _) in zip(
        upright(text).parts, letter(text, size=10).parts, strict=True
    ):
        assert (lx, ly) == pytest.approx((x + SLANT * y, y))


def test_leaning_arcs_follow_the_leaning_circle() -> None:
    circle = parse("0,2 2,0:90 4,2:90 2,4:90 0,2:90")
    (leaning,) = lean((circle,))
    for start, end in itertools.pairwise(leaning):
        middle, radius = centre(start, end)
        turn = 4.0 * math.atan(start[2])
        for k in range(11):
            spot = middle + radius * complex(math.cos(k * turn / 10), math.sin(k * turn / 10))
            back = complex(spot.real - SLANT * spot.imag, spot.imag) - (2 + 2j)
            assert abs(back) == pytest.approx(2.0, rel=0.05)


def directions(stroke: tuple[tuple[float, float, float], ...]) -> list[tuple[float, float]]:
    """Directions (radians) in which the pen comes to and leaves every inner vertex of a stroke."""
    sides = []
    for a, b in itertools.pairwise(stroke):
        chord, half = math.atan2(b[1] - a[1], b[0] - a[0]), 2.0 * math.atan(a[2])
        sides.append((chord - half, chord + half))
    return [(one[1], two[0]) for one, two in itertools.pairwise(sides)]


def test_round_letters_have_no_kinks() -> None:
    for character in "ОСЮоес0S":
        for strokes, allowed in ((glyph(character).strokes, 0.1), (None, 5.0)):
            for stroke in strokes or lean(glyph(character).strokes):
                for come, go in directions(stroke):
                    kink = abs(math.degrees(math.remainder(go - come, 2 * math.pi)))
                    assert kink < allowed or kink > 60.0, character


def test_the_notation_refuses_what_cannot_be_drawn() -> None:
    for path in ("0,0", "0,0:r1 1,0", "0,0 1,0:r2 1,1", "0,0 1,0:r0.5 1,1:90", "0,0 1,1:r1"):
        with pytest.raises(ValueError, match=r"stroke|room|arc"):
            parse(path)


NUMBER = re.compile(r"-?(?:\d+\.\d{1,3}|\.\d{1,3}|\d+)(?![\d.e])")


def read_path(path: str) -> list[tuple[tuple[float, float, float], ...]]:
    """Strokes of an SVG path with the commands M m l h v a, as vertices with bulges, y down."""
    strokes: list[list[tuple[float, float, float]]] = []
    x = y = 0.0
    for command, rest in re.findall(r"([Mmlhva])([^Mmlhva]*)", path):
        assert NUMBER.sub("", rest).strip() == ""
        numbers = [float(word) for word in NUMBER.findall(rest)]
        assert len(numbers) == {"M": 2, "m": 2, "l": 2, "h": 1, "v": 1, "a": 7}[command]
        if command == "a":
            r, _, _, large, sweep, dx, dy = numbers
            half = math.asin(min(1.0, math.hypot(dx, dy) / (2.0 * r)))
            turn = 2.0 * (math.pi - half if large else half)
            strokes[-1][-1] = (x, y, math.tan(turn / 4.0) * (1.0 if sweep else -1.0))
        elif command == "h":
            dx, dy = numbers[0], 0.0
        elif command == "v":
            dx, dy = 0.0, numbers[0]
        else:
            dx, dy = numbers[-2:]
        x, y = (dx, dy) if command == "M" else (x + dx, y + dy)
        if command in "Mm":
            strokes.append([])
        strokes[-1].append((x, y, 0.0))
    return [tuple(stroke) for stroke in strokes]


def same_extremes(written: Lettering, path: str, turn: complex) -> bool:
    turned = tuple(
        tuple(((p := complex(x, y) * turn).real + 100.0, 80.0 - p.imag, -b) for x, y, b in stroke)
        for stroke in written.strokes
    )
    return extremes(tuple(read_path(path))) == pytest.approx(extremes(turned), abs=0.03)


@given(
    st.text(alphabet=ALL, min_size=1, max_size=8),
    st.sampled_from(SIZES),
    st.booleans(),
    st.sampled_from([0.0, 90.0, -37.0, 180.0]),
)
def test_path_comes_back_with_the_same_extreme_points(
    text: str, size: float, inclined: bool, angle: float
) -> None:
    written = letter(escape(text), size=size, inclined=inclined)
    path = svg_path(written, 100.0, 80.0, angle=angle)
    if written.strokes:
        turn = complex(math.cos(math.radians(angle)), math.sin(math.radians(angle)))
        assert same_extremes(written, path, turn)
        assert len(read_path(path)) == len(written.strokes)
    assert not re.search(r"nan|inf|e|-0(?![.\d])|-0?\.0+(?!\d)", path)


def test_path_of_one_pen() -> None:
    written = letter("v_{BA}")
    first, second = (svg_path(written, 10, 20, pen=pen) for pen in written.pens)
    assert first
    assert first + second == svg_path(written, 10, 20) != first


def test_path_has_no_negative_zero_and_no_nan() -> None:
    assert "-0.000" not in svg_path(letter("I.,", inclined=False), -0.25, 0.25)
    assert svg_path(letter("I", inclined=False), -0.2501, 0.2499).startswith("M0 0v")
    for x, y, angle in ((math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, math.nan)):
        with pytest.raises(SheetError, match="cannot stand"):
            svg_path(letter("A"), x, y, angle=angle)


def test_lettering_is_determined_by_its_text() -> None:
    text = r"\uu{\bar{v}_{BA}} = ω_1·l_{OA}, мм^2"
    first = letter(text), svg_path(letter(text), 1.0, 2.0)
    letter.cache_clear()
    assert (compose(text), svg_path(letter(text), 1.0, 2.0)) == first
