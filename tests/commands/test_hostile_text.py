"""Text from a scene is data: escaped, cut to its place or refused; nothing of it leaves the sheet or -o."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
import shapely
from support.command import invoke
from support.each import each
from support.words import BLOCK, quoted, worded

from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.scene.read import read
from graphic_tmm.scene.sections import declared
from graphic_tmm.studio import sheets

NS = "{http://www.w3.org/2000/svg}"
TAGS = ("svg", "g", "path", "rect", "title", "desc")
NAMESPACES = (
    "{http://www.inkscape.org/namespaces/inkscape}",
    "{http://www.w3.org/XML/1998/namespace}",
)
"""Of layers, and of the language: attributes that do nothing."""
SEEN = {
    "markup of a page": "<script>alert(1)</script><a href='x'>&amp; ]]> --></a>",
    "an entity": '<!DOCTYPE s [<!ENTITY e SYSTEM "file:///etc/passwd">]>&e;',
    "quotes": '" onload="x" \'y\' `z`',
    "a path": "../../../etc/passwd",
    "an address": "https://example.org/ javascript:alert(1) url(#a)",
    "lettering": "v_{BA}^{t} \\bar{v} \\uu{x} _ ^ { } \\",
    "open braces": "{{{{ ____ \\u{ \\",
    "typst": '#read("/etc/passwd") #image("x.png") $x$ @y',
    "forms": "%s {0} {name} ${HOME} %n [red]r[/red]",
}
"""Texts that are drawn as they stand."""


def draw(folder: Path, path: Path, forms: str = "svg") -> dict[str, bytes]:
    """Draw; return the files in the output folder by suffix. Nothing else may appear in the folder."""
    before = {p for p in folder.rglob("*")}
    result = invoke("draw", path, "-o", folder / "out", "-f", forms)
    assert (result.exit_code, result.exception) == (0, None), result.output
    after = {p for p in folder.rglob("*") if p not in before and p != folder / "out"}
    assert {p.parent for p in after} == {folder / "out"}
    return {p.name.rpartition(".")[2]: p.read_bytes() for p in after}


def refused(folder: Path, path: Path, *words: str) -> str:
    """Draw what cannot be drawn: status 2, one line that says why, no file or folder more."""
    before = sorted(folder.rglob("*"))
    result = invoke("draw", path, "-o", folder / "out", "-f", "svg,pdf,dxf", "-l", "en")
    assert (result.exit_code, result.stdout) == (2, ""), result.output
    assert sorted(folder.rglob("*")) == before
    assert isinstance(result.exception, SystemExit)
    assert result.stderr.count("\n") == 1, result.stderr
    assert re.match(rf"graphic-tmm: {re.escape(str(path))}:\d+: ", result.stderr), result.stderr
    assert all(word in result.stderr for word in words), result.stderr
    assert result.stderr.rstrip("\n").isprintable()
    return result.stderr


# what is drawn


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("what", SEEN)
def test_a_page_holds_text_and_ink_and_nothing_that_acts(what: str, tmp_path: Path) -> None:
    """In one language each, by turns."""
    text, language = SEEN[what], ("ru", "en")[list(SEEN).index(what) % 2]
    texts = dict.fromkeys(("title", "name", *BLOCK), text)
    out = draw(tmp_path, worded(tmp_path, "A1", language, **texts))["svg"].decode("utf-8")
    assert not re.search(r"<[!?]", out)
    root = ElementTree.fromstring(out)
    assert {e.tag for e in root.iter()} == {NS + tag for tag in TAGS}
    names = {name for e in root.iter() for name in e.attrib}
    plain = [name for name in names if not name.startswith(NAMESPACES)]
    assert not [n for n in plain if "href" in n or n.startswith(("on", "style", "src", "{"))]
    acting = re.compile(r"url\(|javascript:|https?:|data:", re.IGNORECASE)
    values = [v for e in root.iter() for n, v in e.attrib.items() if n != "aria-label"]
    assert not [value for value in values if acting.search(value)]
    meant = " ".join(text.split())
    assert root.find(f"{NS}title").text == meant
    labels = [e.attrib["aria-label"] for e in root.iter() if "aria-label" in e.attrib]
    assert labels.count(meant) >= 1  # the name of a link


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("what", SEEN)
def test_a_pdf_acts_on_nothing_and_points_nowhere(what: str, tmp_path: Path) -> None:
    pdfplumber = pytest.importorskip("pdfplumber")
    pytest.importorskip("typst")
    texts = dict.fromkeys(("title", "name", *BLOCK), SEEN[what])
    data = draw(tmp_path, worded(tmp_path, "A1", **texts), "pdf")["pdf"]
    with pdfplumber.open(io.BytesIO(data)) as file:
        assert not [*file.annots, *file.hyperlinks]
        assert acting(file.doc) == set()
        found = "".join("".join(c["text"] for c in page.chars) for page in file.pages)
        plain = re.sub(r"\s", "", SEEN[what])
        assert plain in re.sub(r"\s", "", found)


ACTS = {
    *("AA", "OpenAction", "JS", "JavaScript", "URI", "Launch", "GoToR", "GoToE", "SubmitForm"),
    *(
        "ImportData",
        "EmbeddedFiles",
        "EmbeddedFile",
        "EF",
        "RichMedia",
        "AcroForm",
        "XFA",
        "Annots",
    ),
}


def acting(document: Any) -> set[str]:
    """Return the keys and names in a PDF by which it could act, or reach outside."""
    numbers = {number for xref in document.xrefs for number in xref.get_objids()}
    roots = [document.catalog, *document.info, *(document.getobj(n) for n in sorted(numbers))]
    return {name for root in roots for name in named(root)} & ACTS


def named(value: Any) -> Iterator[str]:
    if hasattr(value, "attrs"):
        value = value.attrs
    if isinstance(value, dict):
        for key, item in value.items():
            yield key
            yield from named(item)
    elif isinstance(value, list):
        for item in value:
            yield from named(item)
    elif hasattr(value, "name"):
        yield str(value.name)


def test_what_acts_in_a_pdf_would_be_found() -> None:
    pdfplumber = pytest.importorskip("pdfplumber")
    typst = pytest.importorskip("typst")
    data = typst.compile(b'#link("https://example.org")[a]', format="pdf")
    with pdfplumber.open(io.BytesIO(data)) as file:
        assert acting(file.doc) >= {"URI", "Annots"}


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("what", SEEN)
def test_a_dxf_holds_text_and_ink_and_nothing_that_acts(what: str, tmp_path: Path) -> None:
    """A text is what a TEXT says (1), a group or a layer is described by (300, 1000), and nothing else."""
    ezdxf = pytest.importorskip("ezdxf")
    texts = dict.fromkeys(("title", "name", *BLOCK), SEEN[what])
    text = draw(tmp_path, worded(tmp_path, "A1", **texts), "dxf")["dxf"].decode("utf-8")
    rows = text.splitlines()
    assert {
        code.strip()
        for code, value in zip(rows[::2], rows[1::2], strict=True)
        if SEEN[what] in value
    } <= {"1", "300", "1000"}
    document = ezdxf.read(io.StringIO(text))
    assert not document.audit().errors
    kinds = {entity.dxftype() for entity in document.modelspace()}
    lines = {"LINE", "LWPOLYLINE", "CIRCLE", "ARC", "SPLINE"}
    assert kinds <= {*lines, "TEXT", "SOLID", "HATCH", "WIPEOUT", "INSERT"}
    letters = [t.plain_text().replace(" ", "") for t in document.modelspace().query("TEXT")]
    meant = re.sub(r"[\\^\s]", "", SEEN[what])  # what a TEXT could take for a mark is drawn
    assert meant[:12] in "".join(letters)
    assert not [block for block in document.blocks if block.block.is_xref]
    assert not [o for o in document.objects if o.dxftype() in ("IMAGEDEF", "UNDERLAYDEFINITION")]
    assert all(re.fullmatch(r"[\w.~-]+", layer.dxf.name) for layer in document.layers)


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("format", ["A1", "A4"])
@each("language", ["ru", "en"])
@each("word", ["Ж", "слово ", "<&> ", "}_{^\\", "Щ "])
def test_what_is_too_long_for_its_place_is_cut(
    word: str, language: str, format: str, tmp_path: Path
) -> None:
    long = (word * 200)[:199] + "!"
    texts = dict.fromkeys((*BLOCK, "title"), long) | {"name": "n"}
    (sheet, *_) = sheets(read(worded(tmp_path, format, language, **texts)))[1]
    frame = sheet.drawings[0]
    lines = shapely.STRtree([shape(stroke) for stroke in frame.strokes])
    paper = shapely.box(0, 0, sheet.width, sheet.height)
    assert sum("…" in label.text for label in frame.labels) >= 7
    for label in frame.labels:
        assert not lines.query(box(label), predicate="intersects").size, label.text
        assert paper.contains(box(label))


# what is refused


REFUSED = {
    "10 000 characters": ("Ж" * 10_000, "10000 characters; at most 200"),
    "NUL": ("a\0b", "U+0000"),
    "an escape of the terminal": ("\x1b[31mred\x1b]0;x\a", "U+001B"),
    "a line": ("a\nb", "U+000A"),
    "right to left": ("a\u202egnp.exe", "U+202E"),
    "a mark of direction": ("a\u200fb", "U+200F"),
    "a joiner": ("a\u200db", "U+200D"),
    "a line of Unicode": ("a\u2028b", "U+2028"),
    "delete": ("a\x7fb", "U+007F"),
    "no letter for it": ("a字b", '"字" (U+5B57) cannot be lettered; replace it'),
}
KEYS = {
    "title": "title",
    "name": "link 1, name",
    **{key: f"title_block.{key}" for key in ("designation", "drawn_by", "scale")},
}


@each("key", KEYS)
@each("what", REFUSED)
def test_what_cannot_be_drawn_is_refused_once_with_its_key(
    what: str, key: str, tmp_path: Path
) -> None:
    text, says = REFUSED[what]
    said = refused(tmp_path, worded(tmp_path, **{key: text}), f": {KEYS[key]}: ", says)
    assert len(said) < len(str(tmp_path)) + 200


def test_a_text_of_many_strange_characters_is_told_in_a_few_lines(tmp_path: Path) -> None:
    path = worded(tmp_path, title="".join(map(chr, range(0x4E00, 0x4E00 + 200))))
    result = invoke("draw", path, "-o", tmp_path / "out", "-l", "en")
    assert result.exit_code == 2
    assert "200 different characters cannot be lettered" in result.stderr
    assert result.stderr.count("\n") <= 6


WRONG = {
    "<script>": "is not a number with a unit",
    "50 <b>/s": "<b>",
    "50 1/s; rm -rf /": "50 1/s; rm -rf /",
    "__import__('os')": "is not a number with a unit",
    "9" * 10_000: "drive.speed",
    "50 " + "1/" * 5_000 + "s": "drive.speed",
    "50 " + "(" * 5_000: "drive.speed",
}


@pytest.mark.parametrize("text", WRONG, ids=lambda text: text[:12])
def test_a_quantity_is_never_more_than_a_number_and_a_unit(text: str, tmp_path: Path) -> None:
    said = refused(tmp_path, worded(tmp_path, speed=text), ": drive.speed: ", WRONG[text])
    assert len(said) < len(str(tmp_path)) + 400


@each("letter", ["A_", "A{1}", "A\\\\bar", "A^", "<b>", "../B", "A B", "_", "&A;"])
@each("old", ["A = [", "x = {"])
def test_letters_and_guides_hold_no_markup(old: str, letter: str, tmp_path: Path) -> None:
    path = worded(tmp_path)
    text = path.read_text(encoding="utf-8").replace(old, f'"{letter}"{old[1:]}', 1)
    path.write_text(text, encoding="utf-8")
    result = invoke("draw", path, "-o", tmp_path / "out", "-l", "en")
    assert (result.exit_code, result.stdout) == (2, ""), result.output
    where = "frame" if old[0] == "x" else "link 1, points"
    meant = letter.replace("\\\\", "\\")
    assert f'{where}.{meant}: "{meant}" is not a letter' in result.stderr
    assert not (tmp_path / "out").exists()


# names of files


NAMES = [
    "<script>",
    "a & 'b' \"c\"",
    "..",
    "...",
    "-f",
    "$(id)",
    "%s{0}",
    "a;b|c",
    "план",
    "_{^}",
    "#x",
]


PLACES = [(name, stands) for stands in ("folder", "file") for name in NAMES]


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize(("name", "stands"), [p for p in PLACES if p != ("..", "folder")])
def test_files_bear_the_name_of_the_scene_and_stay_in_their_folder(
    name: str, stands: str, tmp_path: Path
) -> None:
    home = tmp_path / "a" / "b" / (name if stands == "folder" else "c")
    home.mkdir(parents=True)
    path = worded(home)
    if stands == "file":
        path = path.rename(home / f"{name}.toml")
    files = draw(tmp_path, path, "svg,pdf,dxf")
    made = {p.name for p in (tmp_path / "out").iterdir()}
    assert made == {f"{name}.{form}" for form in ("svg", "pdf", "dxf")}
    (tmp_path / "plain").mkdir()
    assert files == draw(tmp_path / "plain", worded(tmp_path / "plain"), "svg,pdf,dxf")


@pytest.mark.parametrize("way", ["b/../scene.toml", "../a/b/..", "./.", "b/../../a"])
def test_a_way_with_dots_names_the_folder_it_leads_to(
    way: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a" / "b").mkdir(parents=True)
    worded(tmp_path / "a")
    monkeypatch.chdir(tmp_path / "a")
    before = sorted(tmp_path.rglob("*"))
    assert invoke("draw", way, "-o", "out").exit_code == 0
    new = [p.relative_to(tmp_path) for p in sorted(tmp_path.rglob("*")) if p not in before]
    assert [str(p) for p in new] == ["a/out", "a/out/a.svg"]


def test_a_link_in_the_output_folder_is_replaced_and_not_followed(tmp_path: Path) -> None:
    path, away = worded(tmp_path), tmp_path / "away"
    (tmp_path / "out").mkdir()
    away.write_text("mine", encoding="utf-8")
    (tmp_path / "out" / f"{tmp_path.name}.svg").symlink_to(away)
    assert invoke("draw", path, "-o", tmp_path / "out").exit_code == 0
    assert away.read_text(encoding="utf-8") == "mine"
    assert not (tmp_path / "out" / f"{tmp_path.name}.svg").is_symlink()


def test_a_name_too_long_for_its_files_is_refused_and_nothing_left(tmp_path: Path) -> None:
    path = worded(tmp_path).rename(tmp_path / f"{'x' * 252}.ab")
    result = invoke("draw", path, "-o", tmp_path / "out")
    assert (result.exit_code, result.stdout) == (2, ""), result.output
    assert "name too long" in result.stderr or "имя слишком длинное" in result.stderr
    assert not (tmp_path / "out").exists()


@each("text", [REFUSED[what][0] for what in REFUSED])
@each(
    "old, new",
    [
        ("title =", "{} = 1\ntitle ="),
        ('along = "x"', "along = {}"),
        ('A = ["0.3', '{} = ["0.3'),
        ('speed = "50 1/s"', "speed = {}"),
        ('format = "A4"', "format = {}"),
    ],
)
def test_a_message_does_nothing_to_the_terminal(
    old: str, new: str, text: str, tmp_path: Path
) -> None:
    path = worded(tmp_path)
    written = path.read_text(encoding="utf-8")
    path.write_text(written.replace(old, new.format(quoted(text)), 1), encoding="utf-8")
    result = invoke("draw", path, "-o", tmp_path / "out")
    assert (result.exit_code, result.stdout) == (2, ""), result.output
    assert all(line.isprintable() for line in result.stderr.split("\n"))
    listed = len(", ".join(declared()))  # what an unknown section may be instead
    assert len(max(result.stderr.splitlines(), key=len)) < len(str(path)) + listed + 250
    assert not (tmp_path / "out").exists()
