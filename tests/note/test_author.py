"""What the author of a note says: told in its place as written, in every format; nothing where nothing is."""

from __future__ import annotations

import io
import re
import subprocess
from collections.abc import Mapping
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pypdfium2
import pytest
from docx import Document as read_docx
from support.each import each
from support.notes import document_of, noted, spoken

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SceneError
from graphic_tmm.note.document import Break, Document, Heading, Listed, Paragraph, Text, walk
from graphic_tmm.note.formats import FORMATS, files
from graphic_tmm.note.note import note
from graphic_tmm.note.pandoc import program
from graphic_tmm.scene.author import Author
from graphic_tmm.scene.document import toml
from graphic_tmm.scene.read import read

NAME = "slider-diagrams"
NASTY = {
    "ministry": "<script>alert(1)</script> & \"quotes\" 'apostrophes'",
    "university": "$x^2$ $$y$$ \\par \\input{/etc/passwd} {a} % comment",
    "department": '#read("/etc/passwd") #set text(red) @ref <label> = Heading',
    "discipline": "*bold* _it_ `code` [link](http://x) ![i](y) ~~s~~ :smile:",
    "theme": "^sup^ ~sub~ // comment /* c */ -- --- ... \\u{1F600} \\\\",
    "variant": "#8 & <9> | 10",
    "group": "М-31 {0} %s ${HOME} |",
    "city": "1) Киров",
}
"""Lines of the title page, with all that formats know as signs of their own."""
WORDS = (
    "# Heading of Markdown",
    "= Heading of typst",
    "- a list",
    "1. a list",
    "| a | b |",
    "---",
    "***",
    "===",
    "> quote",
    "$ 5 и 6 $ \\( z \\) \\[ w \\]",
    "\\begin{equation} x",
    "<!-- c --> &amp; &#60; &nbsp;",
    "]]> </w:t> <w:br/>",
    "#pagebreak() #panic()",
    "/ term: x",
    "+ plus",
    "http://example.org/?a=1&b=2#c",
    "a~b -- e --- f ... g",
    "«ёлочки» „лапки“ — № 5 ½ × ° λ μ",
)
"""Paragraphs with what begins something else in one format or another."""
PLACES = ("machine", "introduction", "conclusions", "literature")


def saying(**said: object) -> DrawnScene:
    """The scene drawn once, with an author who says something else."""
    from dataclasses import replace

    drawn = spoken(NAME, "ru")
    scene = replace(drawn.scene, author=Author(**said))  # type: ignore[arg-type]
    boards = tuple(replace(one, project=replace(one.project, scene=scene)) for one in drawn.boards)
    return DrawnScene(scene, boards)


@cache
def nasty() -> Document:
    words: dict[str, object] = {place: WORDS for place in PLACES}
    return note(saying(**NASTY, **words, year=2026, remarks={"diagrams": WORDS}))


@cache
def written(form: str) -> str:
    """All that a file of the nasty note says, as a reader of that format has it; white space as one space."""
    found = files(nasty(), "note", (form,))[f"note.{form}"]
    return " ".join(READERS[form](found).split())


class _Words(HTMLParser):
    """The text of a page; ``tags``: the elements it has."""

    def __init__(self) -> None:
        super().__init__()
        self.told: list[str] = []
        self.tags: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)

    def handle_data(self, data: str) -> None:
        self.told.append(data)


def of_page(found: str | bytes) -> str:
    page = _Words()
    assert isinstance(found, str)
    page.feed(found)
    assert not page.tags & {"script", "b", "i", "u", "del", "hr", "blockquote"}
    return " ".join(page.told)


def of_docx(found: str | bytes) -> str:
    assert isinstance(found, bytes)
    read = read_docx(io.BytesIO(found))
    document_of(found)
    cells = [cell.text for row in read.tables[0].rows for cell in row.cells]
    return " ".join([*(one.text for one in read.paragraphs), *cells])


def of_pdf(found: str | bytes) -> str:
    book = pypdfium2.PdfDocument(found)
    pages = [page.get_textpage().get_text_range() for page in book]
    book.close()
    return " ".join(pages)


def of_markdown(found: str | bytes) -> str:
    """What Markdown says to another's reader of it."""
    assert isinstance(found, str)
    command = [program(), "-f", "gfm", "-t", "plain", "--wrap=none"]
    ended = subprocess.run(command, input=found.encode("utf-8"), capture_output=True, check=True)
    return ended.stdout.decode("utf-8")


READERS = {"html": of_page, "docx": of_docx, "pdf": of_pdf, "md": of_markdown}


@each("form", FORMATS)
@pytest.mark.slow
def test_words_of_the_author_are_data_in_every_format(form: str) -> None:
    told = written(form)
    for words in (*NASTY.values(), *WORDS):
        assert " ".join(words.split()) in told, words
    assert "«*bold*" in told
    assert "1) Киров 2026" in told


@each("form", FORMATS)
def test_words_stand_in_each_place_that_takes_them(form: str) -> None:
    """Each word of the introduction stands twice, then with the remark, the conclusions, the literature."""
    assert written(form).count("#pagebreak() #panic()") == len(PLACES) + 1


def order(document: Document) -> list[str]:
    """The headings of the first level, with the first text below each."""
    return [
        "".join(run.text for run in block.runs if isinstance(run, Text))
        for block in document.blocks
        if isinstance(block, Heading) and block.level == 1
    ]


def title_page(document: Document) -> list[Paragraph]:
    page = []
    for block in document.blocks:
        if isinstance(block, Break):
            break
        page += [block] if isinstance(block, Paragraph) else []
    return page


def words_of(page: list[Paragraph]) -> list[str]:
    return [one.runs[0].text for one in page if isinstance(one.runs[0], Text)]  # type: ignore[misc]


def test_without_words_of_the_author_nothing_stands_for_them() -> None:
    made = note(saying())
    told = [one.strip() for one in words_of(title_page(made))]
    assert [one for one in told if one] == [
        "Пояснительная записка",
        "к курсовому проекту по теории механизмов и машин",
        "Кинематические диаграммы ползуна",
    ]
    assert "Введение" not in order(made)
    listed = [block for block in made.blocks if isinstance(block, Listed)][-1]
    assert len(listed.items) >= 4


def test_a_note_with_words_has_them_where_they_belong() -> None:
    own = {"machine": ("Машина.",), "introduction": ("Работа.",), "conclusions": ("Итог.",)}
    made = note(saying(**own, literature=("Книга.",), remarks={"diagrams": ("Кривые.",)}))
    heads = order(made)
    assert heads[0] == "Введение"
    assert heads[-1] == "Список литературы"
    told = [
        run.text
        for block in walk(made.blocks)
        if isinstance(block, Heading | Paragraph)
        for run in block.runs
        if isinstance(run, Text)
    ]
    places = [
        told.index(word) for word in ("Введение", "Машина.", "Работа.", "Диаграммы", "Кривые.")
    ]
    places += [told.index(word) for word in ("Заключение", "Итог.", "Список литературы", "Книга.")]
    assert places == sorted(places)
    assert told[places[3] + 1] == "Кривые."
    assert len([block for block in made.blocks if isinstance(block, Listed)][-1].items) == 1


@pytest.mark.parametrize(
    ("kind", "told"),
    [
        ("course project", "к курсовому проекту"),
        ("course work", "к курсовой работе"),
        ("graphical assignment", "к расчётно-графической работе"),
        ("diploma project", "к дипломному проекту"),
    ],
)
def test_the_title_page_tells_the_kind_of_work_in_its_case(kind: str, told: str) -> None:
    page = words_of(title_page(note(saying(kind_of_work=kind, discipline="ТММ", theme="Пресс"))))
    at = page.index("Пояснительная записка")
    assert page[at + 1 : at + 5] == [told, "по дисциплине «ТММ»", "на тему", "Пресс"]


def test_the_page_of_a_docx_holds_its_title_page_whole() -> None:
    """Empty lines take what the others leave: the foot stands on the first page, whatever is told above."""
    found = files(nasty(), "note", ("docx",))["note.docx"]
    assert isinstance(found, bytes)
    text = re.findall(r'"Space"/><w:spacing w:before="(\d+)"', _document(found))
    assert len(text) == 3
    assert all(200 < int(one) < 4000 for one in text)
    full = files(note(saying(theme="Т" * 1500)), "note", ("docx",))["note.docx"]
    assert isinstance(full, bytes)
    assert set(re.findall(r'"Space"/><w:spacing w:before="(\d+)"', _document(full))) == {"0"}


def _document(found: bytes) -> str:
    from support.notes import parts

    return parts(found)["word/document.xml"].decode("utf-8")


# the section of a scene


PLAIN = """title = "T"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = ["0.1 m", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["0.3 m", 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "380 rpm"
[note]
"""


def author(folder: Path, text: str) -> Author:
    (folder / "scene.toml").write_text(PLAIN + text, encoding="utf-8")
    return read(folder).author


def test_paragraphs_are_a_text_or_several_or_a_text_with_empty_lines(tmp_path: Path) -> None:
    one = author(
        tmp_path, 'machine = """\n  a\nb\n \n\nc\t d  """\nintroduction = ["e", "f\\n\\ng"]'
    )
    assert one.machine == ("a b", "c d")
    assert one.introduction == ("e", "f", "g")


def test_lines_that_are_left_empty_are_not_there(tmp_path: Path) -> None:
    assert author(tmp_path, 'city = " "\nmachine = ""\nliterature = []\n') == Author()


def test_numbers_may_be_numbers(tmp_path: Path) -> None:
    one = author(tmp_path, "variant = 8\ngroup = 31\nyear = 2026")
    assert (one.variant, one.group, one.year) == ("8", "31", 2026)


REFUSED = {
    "a key": ('univercity = "x"', "note.univercity", 'did you mean "university"'),
    "a number": ("city = 5", "note.city", "a text in quotes is wanted"),
    "a kind of work": ('kind_of_work = "course wrok"', "note.kind_of_work", '"course work"'),
    "a year": ("year = 26", "note.year", "a whole number 1900 to 2200 is wanted"),
    "a year in quotes": ('year = "2026"', "note.year", "a whole number is wanted, without quotes"),
    "a list of others": ("machine = [5]", "note.machine", "one a paragraph"),
    "a variant": ("variant = 1.5", "note.variant", "a whole number is wanted, or a text"),
    "NUL": ('city = "a\\u0000b"', "note.city", r"U\+0000 cannot be written into a note"),
    "no character": ('machine = "a\\uFFFE"', "note.machine", r"U\+FFFE cannot be written"),
    "right to left": ('theme = "a\\u202Eb"', "note.theme", r"U\+202E cannot be written"),
    "a long line": (f'city = "{"x" * 201}"', "note.city", "has 200 at most"),
    "a long paragraph": (f'machine = "{"x" * 4001}"', "note.machine", "an empty line between"),
    "a chapter": (
        'remarks = { cem = "x" }',
        "note.remarks.cem",
        'did you mean "cam".*chapters are',
    ),
    "no table": ('remarks = "x"', "note.remarks", "a table is wanted"),
}


@each("what", REFUSED)
def test_what_cannot_be_told_is_refused_with_key_and_remedy(what: str, tmp_path: Path) -> None:
    text, key, says = REFUSED[what]
    with pytest.raises(SceneError) as error:
        author(tmp_path, text)
    (one,) = error.value.faults
    assert (one.key, one.line) == (key, PLAIN.count("\n") + 1)
    assert re.search(says, one.message), one.message


def test_words_for_a_chapter_that_is_not_called_for_are_told(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(
        PLAIN + f"remarks = {toml({'cam': 'x', 'kinematics': 'y'})}", encoding="utf-8"
    )
    remarks = read(tmp_path).remarks
    assert [one for one in remarks if "note." in one] == [
        "note.remarks.cam: the scene asks for nothing of this chapter, so the note has no section for it"
    ]


SOURCES: Mapping[str, tuple[str, ...]] = {
    "slider-diagrams": ("на тему", "Построение кинематических диаграмм"),
    "lever": ("по дисциплине «Теория механизмов и машин»", "на тему"),
}


@each("name", SOURCES)
@pytest.mark.slow
def test_scenes_of_the_package_say_what_their_documents_do(name: str) -> None:
    page = words_of(title_page(noted(name)))
    assert set(SOURCES[name]) <= set(page)
