"""Letters of points and texts that are drawn."""

import pytest

from graphic_tmm.scene.letters import clash, letter_fault, split, text_fault, undrawable, unknown


@pytest.mark.parametrize("letter", ["A", "S2", "Д", "Ω", "C′", "A12′", "a"])
def test_letters(letter):
    assert letter_fault(letter) == ""


@pytest.mark.parametrize("letter", ["", "AB", "1A", "A1234", "A-1", "C'", "_", "A b", "x" * 50])
def test_what_is_no_letter(letter):
    assert "is not a letter" in letter_fault(letter)


@pytest.mark.parametrize(
    ("pole", "plan"),
    [("P", "velocity"), ("p", "velocity"), ("Π", "acceleration"), ("π", "acceleration")],
)
def test_poles(pole, plan):
    assert f"pole of the {plan} plan; choose another letter" in letter_fault(pole)
    assert letter_fault(pole, pole=False) == ""


def test_clashes():
    assert "writes small letters; rename" in clash("A", "a")
    assert '"А" (Russian) looks like "A" (Latin)' in clash("A", "А")
    assert "looks like" in clash("O", "о")
    assert clash("A", "A") == clash("A", "B") == clash("A1", "A2") == ""


def test_two_letters_together():
    assert split("BC") == ("B", "C")
    assert split("S3C′") == ("S3", "C′")
    assert [split(text) for text in ("B", "BCD", "B C", "y-y", "")] == [None] * 5


def test_an_unknown_letter_names_the_near_one():
    assert unknown("no", "А", ["A", "B"], "letters") == (
        'no; did you mean "A" (Latin, not Russian)?; letters are A, B'
    )
    assert (
        unknown("no", "S2", ["S3", "B"], "letters") == 'no; did you mean "S3"?; letters are B, S3'
    )
    assert unknown("no", "Q", [], "letters of link 2") == "no; letters of link 2 are none"


def test_texts():
    assert text_fault("x" * 200) == ""
    assert "201 characters; at most 200" in text_fault("x" * 201)
    for code in (0, 7, 10, 0x7F, 0x202E, 0x2028):
        assert f"U+{code:04X}" in text_fault(f"a{chr(code)}b")


def test_undrawable_characters_are_named_once_each():
    assert undrawable("a字b字", "字") == [
        'the character "字" (U+5B57) cannot be lettered; replace it'
    ]
