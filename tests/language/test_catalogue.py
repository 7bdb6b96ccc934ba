"""Catalogues: every text of the package is in each, with its placeholders, and nothing else is."""

from __future__ import annotations

import ast
import copy
import pickle
import re
from pathlib import Path

import pytest
from babel import Locale
from babel.messages.pofile import read_po
from babel.plural import PluralRule
from support.messages import PACKAGE, calls, messages, nodes, places, sources

from graphic_tmm.language import catalogue
from graphic_tmm.language.catalogue import Catalogue, Speech, languages, read_catalogue, speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.language.units import BASE, unit

OTHERS = tuple(language for language in languages() if language != "en")
CYRILLIC = re.compile("[а-яА-ЯёЁ]")

RUSSIAN_BY_NATURE = {
    "paper/formats.py": "А4 as people write it in Russian: input",
    "paper/lettering/glyph_tables.py": "the Cyrillic alphabet's own strokes, and letters that have them",
    "scene/length_task.py": "input: kinds of mechanisms that a task asks for",
    "chapters/lettering/views.py": "a specimen shows Cyrillic letters, and puts Ё behind Е",
    "checking/readings/csv_cells.py": "input: titles typed with Cyrillic letters that look like x and y, мм",
    "checking/readings/figures.py": "input: мм behind a figure",
    "checking/readings/filling.py": "input: words for the same again",
    "checking/readings/layouts.py": "input: units and quantities in titles",
    "checking/readings/letters.py": "input: the title of a row of letters",
    "checking/readings/position_names.py": "input: words before a position, degrees, look-alikes",
    "checking/readings/quantity_names.py": "input: indices of components in Cyrillic",
    "checking/readings/names.py": "input: words, endings of names; Cyrillic letters by shape and sound",
    "checking/congruence/stated.py": "input: what people write for a scale factor",
    "chapters/cylinders/task.py": "input: Russian synonyms of choices",
    "scene/units.py": "input: units as Russian task sheets write them",
    "scene/quantities.py": "input: the word of kgf",
    "scene/misfits.py": "input: yes and no",
    "scene/coordinates.py": "input: the Russian word of the other extreme",
    "scene/values.py": "input: Russian synonyms of choices",
    "scene/guides.py": "input: Russian synonyms of choices",
    "scene/letters.py": "input: letters of points may be Cyrillic; which of them look alike",
    "scene/author.py": "input: Russian synonyms of choices; examples of an author's words",
    "scene/drawing.py": "input: Russian synonyms of choices; the example of a title",
    "scene/mechanism.py": "input: Russian synonyms of choices",
    "chapters/balance/task.py": "input: Russian synonyms of choices",
    "chapters/diagrams/task.py": "input: Russian synonyms of choices",
    "chapters/engine/task.py": "input: Russian synonyms of choices",
    "chapters/flywheel/task.py": "input: Russian synonyms of choices",
    "chapters/forces/kinds.py": "input: Russian synonyms of choices",
    "chapters/klein/task.py": "input: Russian synonyms of choices",
    "chapters/indicator/task.py": "input: Russian synonyms of choices",
    "chapters/motion_law/record.py": "input: the Russian word for the speeds that it gives",
}
"""Files whose code holds Cyrillic text, with the reason."""


def held(language: str) -> Catalogue:
    return read_catalogue(catalogue.FOLDER / f"{language}.po")


@pytest.mark.parametrize("language", OTHERS)
def test_every_text_of_the_package_is_in_the_catalogue(language: str) -> None:
    texts = held(language).texts
    assert not [(one.file, one.text) for one in messages() if one.key not in texts]


@pytest.mark.parametrize("language", OTHERS)
def test_no_text_of_the_catalogue_is_unused(language: str) -> None:
    assert not set(held(language).texts) - {one.key for one in messages()}


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_has_the_placeholders_of_its_text(language: str) -> None:
    for (_, text), told in held(language).texts.items():
        for form in told:
            assert places(form) == places(text), text


def test_places_are_told_from_indices() -> None:
    assert places("{n:.3g} of {what} in D_{e} and D_{{e}} = {outer}, x^{2}") == (
        "n",
        "outer",
        "what",
    )


def test_the_words_of_a_text_are_written_out() -> None:
    """A text put together before it is looked up is in no catalogue."""
    for file in sources():
        for call in calls(file):
            assert not isinstance(call.args[0], ast.JoinedStr), f"{file}:{call.lineno}"
            assert not isinstance(call.args[0], ast.BinOp), f"{file}:{call.lineno}"


def code_of(file: Path) -> str:
    """Return the text constants of a file but its docstrings, and the names of its keyword arguments."""
    there = nodes(file)
    bare = {id(node.value) for node in there if isinstance(node, ast.Expr)}
    texts = [
        str(node.value)
        for node in there
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in bare
    ]
    names = [node.arg for node in there if isinstance(node, ast.keyword) and node.arg]
    return " ".join([*texts, *names])


def test_other_languages_stand_in_catalogues_only() -> None:
    found = {str(file.relative_to(PACKAGE)) for file in sources() if CYRILLIC.search(code_of(file))}
    assert found == set(RUSSIAN_BY_NATURE)


@pytest.mark.parametrize("language", OTHERS)
def test_a_catalogue_is_read_as_babel_reads_it(language: str) -> None:
    with (catalogue.FOLDER / f"{language}.po").open("rb") as file:
        due = read_po(file, abort_invalid=True)
    texts = {}
    for one in due:
        if one.id:
            text = one.id[0] if isinstance(one.id, (tuple, list)) else one.id
            told = one.string if isinstance(one.string, tuple) else (one.string,)
            texts[one.context or "", text] = told
    assert held(language).texts == texts
    assert due.locale is not None
    assert due.locale.language == language
    assert f"({held(language).plurals.strip('()')})" == f"({due.plural_expr.strip('()')})"


@pytest.mark.parametrize("language", OTHERS)
def test_plurals_and_decimal_sign_are_those_of_the_unicode_locale(language: str) -> None:
    locale = Locale(language)
    rule: PluralRule = locale.plural_form
    speech = speaking(language)
    forms: dict[str, set[str]] = {}
    for n in range(1000):
        text = speech("{n} position", "{n} positions", n=n).replace(str(n), "#", 1)
        forms.setdefault(rule(n), set()).add(text)
    assert all(len(texts) == 1 for texts in forms.values()), forms
    assert len(set().union(*forms.values())) == len(forms)
    assert decimal_sign(language) == locale.number_symbols["latn"]["decimal"]


def test_reading_escapes_several_lines_comments_and_what_is_fuzzy(tmp_path: Path) -> None:
    file = tmp_path / "xx.po"
    file.write_text(
        'msgid ""\nmsgstr "Plural-Forms: nplurals=1; plural=0;\\n"\n\n'
        '# a remark\n#: a.py\nmsgctxt "c"\nmsgid "a "\n"\\"b\\""\nmsgstr ""\n"x\\n"\n"y"\n\n'
        '#, fuzzy\nmsgid "guessed"\nmsgstr "?"\n\nmsgid "none"\nmsgstr ""\n\n'
        'msgid "{n} ox"\nmsgid_plural "{n} oxen"\nmsgstr[0] "{n} vaca"',
        encoding="utf-8",
    )
    assert read_catalogue(file) == ({("c", 'a "b"'): ("x\ny",), ("", "{n} ox"): ("{n} vaca",)}, "0")


SPOKEN = Speech(
    "xx",
    {
        ("", "no {what}; {remedy}"): ("{remedy}! {what} fehlt",),
        ("", "scene"): ("Szene",),
        ("a verb", "scene"): ("?",),
        ("", "write {n} line"): ("eine Zeile", "{n} Zeilen"),
    },
)


def test_what_is_nested_is_said_in_the_language_too() -> None:
    remedy = said("write {n} line", "write {n} lines", n=3)
    text = said("no {what}; {remedy}", what=said("scene"), remedy=remedy)
    assert text == "no scene; write 3 lines"
    assert SPOKEN(text) == "3 Zeilen! Szene fehlt"
    assert SPOKEN(joined("; ", ["{a}", text, said("scene", context="a verb")])) == (
        "{a}; 3 Zeilen! Szene fehlt; ?"
    )
    assert SPOKEN(said("write {n} line", "write {n} lines", n=1)) == "eine Zeile"
    assert SPOKEN("a title {of} a scene") == "a title {of} a scene"


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda t: pickle.loads(pickle.dumps(t))]
)
def test_a_text_that_is_copied_can_still_be_said(again) -> None:  # type: ignore[no-untyped-def]
    text = again(said("no {what}; {remedy}", what=said("scene"), remedy="x"))
    assert isinstance(text, Said)
    assert SPOKEN(text) == "x! Szene fehlt"


def test_a_text_without_values_keeps_its_braces() -> None:
    assert said("V_{pl}") == "V_{pl}" == speaking("en")("V_{pl}")
    assert speaking("ru")("V_{pl}") == "V_{пл}"


def test_a_unit_is_made_of_base_units_each_with_its_name() -> None:
    assert unit("(kgf·m)/mm", "ru") == "(кгс·м)/мм"
    assert unit("1/s²", "ru") == "с⁻²"
    assert unit("furlong", "ru") == "furlong"
    assert all(not re.search("[A-Za-z]", unit(name, "ru")) for name in BASE)


def test_a_figure_that_a_sentence_rounds_has_the_sign_of_the_language() -> None:
    """What is to be written into a scene is text already, and stays so."""
    told = said(
        '{x:.2f} mm, {n} of {k:.0f}: write mu_l = "{value}"', x=1.5, n=2, k=3.0, value="0.01 m/mm"
    )
    for language in languages():
        sign = decimal_sign(language)
        assert speaking(language)(told) == f'1{sign}50 mm, 2 of 3: write mu_l = "0.01 m/mm"'
