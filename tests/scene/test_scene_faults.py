"""Scenes that are wrong: every fault with its key, its line and the remedy, all at once."""

import copy
import re
import tomllib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.gallery import SHEETS

from graphic_tmm.errors import SceneError
from graphic_tmm.scene import build, checks, references, sections
from graphic_tmm.scene.lines import fault
from graphic_tmm.scene.read import read

pytestmark = pytest.mark.every

GOOD = """title = "T"
language = "ru"
[lengths]
r = "0.1 m"
[frame]
number = 0
O = [0, 0]
x = { through = [0, 0], angle = 0 }
v = { through = [0, 0], angle = 90 }
[[link]]
number = 1
points = { O = [0, 0], A = ["r", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["3 r", 0] }
mass = "2 kg"
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "380 rpm"
positions = 12
accelerations = [2, 6]
[scales]
mu_l = 0.005
[plans]
trajectories = ["B"]
[[sheet]]
format = "A1"
[title_block]
name = "N"
"""


def faults_of(tmp_path, text, **options):
    file = tmp_path / "scene.toml"
    file.write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(SceneError) as error:
        read(file, **options)
    assert error.value.path == str(file)
    return error.value.faults


def test_the_example_is_good(tmp_path):
    (tmp_path / "scene.toml").write_text(GOOD, encoding="utf-8")
    assert read(tmp_path).title == "T"


L3 = "link 3, "
CASES = [
    # what is replaced, by what, key, line of the replacement, words of the message
    ('title = "T"\n', "", "title", 0, '"title" is missing; write for example title = '),
    ('"T"', '" "', "title", 1, "title is empty"),
    ('"T"', "5", "title", 1, "the number 5 stands here; a text in quotes"),
    ('"T"', '"%s"' % ("x" * 201), "title", 1, "at most 200"),
    ('"T"', '"a\\u0007"', "title", 1, r"control character U\+0007"),
    ("language", "langauge", "langauge", 2, 'did you mean "language"'),
    ('"ru"', '"de"', "language", 2, 'one of "ru", "en"'),
    ('r = "0.1 m"', 'r = "0.1 kg"', "lengths.r", 4, "is a mass; a length is wanted"),
    ('r = "0.1 m"', 'r = "0.1 m"\nmm = 1', "lengths.mm", 5, "is a unit of length; choose another"),
    ('r = "0.1 m"', 'r = "0.1 m"\n"a b" = 1', "lengths.a b", 5, "cannot name a length"),
    ("number = 0", "nubmer = 6", "frame.nubmer", 6, 'did you mean "number"'),
    ("number = 0", 'number = "0"', "frame.number", 6, "whole number is wanted, without quotes"),
    ("number = 0", "number = 2", "link 2, number", 14, "number of the frame"),
    ("O = [0, 0]\nx", "O = [0, 0, 0]\nx", "frame.O", 7, "a list of 3.*list of two lengths"),
    ("O = [0, 0]\nx", 'O = [0, "5 kg"]\nx', "frame.O", 7, "y: .*is a mass; a length is wanted"),
    ("O = [0, 0]\nx", "O = [true, 0]\nx", "frame.O", 7, "x: true"),
    ("O = [0, 0]\nx", "O = [nan, 0]\nx", "frame.O", 7, "x: nan is not a finite number"),
    ("x = {", 'P = [1, 1]\nx = {', "frame.P", 8, "pole of the velocity plan; choose another"),
    ("x = {", '"π" = [1, 1]\nx = {', "frame.π", 8, "pole of the acceleration plan"),
    ("x = {", "Ax = [1, 1]\nx = {", "frame.Ax", 8, "is not a letter.*such as A, S2"),
    ("x = {", "Q = [0, 0]\nx = {", "frame.Q", 8, "O and Q lie at the same place.*move one"),
    ("x = {", "a = [1, 0]\nx = {", "link 1, points.A", 13, 'both be "a" on a plan.*rename'),
    ("x = {", '"А" = [1, 0]\nx = {', "link 1, points.A", 13, "looks like .*Russian"),
    ("angle = 0 }", 'angle = "1 mm" }', "frame.x.angle", 8, "is a length; an angle is wanted"),
    (", angle = 0 }", " }", "frame.x.angle", 8, '"angle" is missing; write for example angle'),
    ("angle = 0 }", "angel = 0 }", "frame.x.angel", 8, 'did you mean "angle"'),
    ("number = 1\n", "", "link (the 1st in the file), number", 10, '"number" is missing'),
    ("number = 1\n", "number = true\n", "link (the 1st in the file), number", 11, "whole number"),
    ("number = 1\n", "number = -1\n", "link -1, number", 11, "whole number 0 to 999"),
    ("number = 3\n", "number = 2\n", "link (the 3rd in the file), number", 18,
     "number of another link; write 3"),
    ('["r", 0]', '["R0", 0]', "link 1, points.A", 12, "x: 'R0' is neither.*named lengths are r"),
    ('["r", 0]', "[0, 0]", "link 1, points.A", 12, "length OA is zero"),
    ('["r", 0]', '["1 000 mm", 0]', "link 1, points.A", 12, "two ways; write the number"),
    ('points = { B', 'point = { B', L3 + "point", 19, 'did you mean "points"'),
    ("points = { B = [0, 0] }", "points = 5", L3 + "points", 19, "a table is wanted, for example"),
    ('mass = "2 kg"', 'mass = "2 N*m"', "link 2, mass", 16, "is a moment; a mass is wanted"),
    ('mass = "2 kg"', 'mass = "-2 kg"', "link 2, mass", 16, "is less than 0"),
    ('mass = "2 kg"', "mass = false", "link 2, mass", 16, "false .*a mass is wanted"),
    ('mass = "2 kg"', 'J = "2 kg"', "link 2, J", 16, "is a mass; a moment of inertia is wanted"),
    ('mass = "2 kg"', 'centre = "S"', "link 2, centre", 16, '"S" is not a letter of this link'),
    ('mass = "2 kg"', 'side = "left AC"', "link 2, side", 16, 'write "left of AC"'),
    ('mass = "2 kg"', 'side = "left of AC"', "link 2, side", 16,
     '"C" is not a letter of the mechanism.*are A, B, O'),
    ('mass = "2 kg"', "flips_at = [90]", "link 2, flips_at", 16, 'write "side" as well'),
    ('mass = "2 kg"', 'flips_at = ["1 m"]', "link 2, flips_at", 16, "an angle is wanted"),
    ('on = "frame"', "on = 7", L3 + "slides.on", 20, r"no link 7; links are 0, 1, 2, 3"),
    ('on = "frame"', 'on = "ground"', L3 + "slides.on", 20, 'number of a link, or "frame"'),
    ('on = "frame"', "on = 3", L3 + "slides.on", 20, "cannot slide on itself"),
    ('along = "x"', 'along = "X"', L3 + "slides.along", 20, 'did you mean "x"'),
    ('along = "x"', 'along = "OC"', L3 + "slides.along", 20, '"C" is not a letter of the frame'),
    ('along = "x"', 'along = "OO"', L3 + "slides.along", 20, "names one letter twice"),
    ('along = "x", ', "", L3 + "slides.along", 20, '"along" is missing'),
    ('side = "right"', 'side = "rihgt"', L3 + "slides.side", 20, 'did you mean "right"'),
    ('side = "right"', 'side = "above"', L3 + "slides.side", 20,
     'guide x lies square to "above"; write "left" or "right"'),
    ('"x", side = "right"', '"v", side = "слева"', L3 + "slides.side", 20,
     'lies square to "left"; write "above" or "below"'),
    ('on = "frame", along = "x"', 'on = 2, along = "AB"', L3 + "slides.side", 20,
     'on a guide that moves; write "\\+" or "-"'),
    ('side = "right" }', 'sied = "right" }', L3 + "slides.sied", 20, 'did you mean "side"'),
    ('side = "right" }', 'offset = "OX" }', L3 + "slides.offset", 20, "neither a named length"),
    ('side = "right" }', "flips_at = [90] }", L3 + "slides.flips_at", 20, 'write "side" as well'),
    ("link = 1\n", "link = 9\n", "drive.link", 22, "no link 9; links are 0, 1, 2, 3"),
    ("link = 1\n", "link = 0\n", "drive.link", 22, "is the frame, which does not turn"),
    ("link = 1\n", "", "drive.link", 21, '"link" is missing; write for example link = 1'),
    ('"380 rpm"', "-5", "drive.speed", 23, 'negative; write it positive and turns = "clockwise"'),
    ('"380 rpm"', '"380 m/s"', "drive.speed", 23, "link 1 slides on nothing: write its angular speed"),
    ('"380 rpm"', '"380"', "drive.speed", 23, 'has no unit; write "380 rpm"'),
    ('"380 rpm"', '"1e400 rpm"', "drive.speed", 23, "not a finite number"),
    ('"380 rpm"', '"380 rpm"\nturns = "left"', "drive.turns", 24, 'one of "counterclockwise"'),
    ('"380 rpm"', '5\nacceleration = "1 rpm"', "drive.acceleration", 24,
     "an angular acceleration is wanted"),
    ('"380 rpm"', '5\nzero = { point = "K", at = "left" }', "drive.zero.point", 24,
     '"K" is not a letter of the mechanism'),
    ('"380 rpm"', '5\nzero = { point = "O", at = "left" }', "drive.zero.point", 24,
     "stands on the frame and does not move"),
    ('"380 rpm"', '5\nzero = { point = "B", at = "lefft" }', "drive.zero.at", 24,
     'did you mean "left"'),
    ('"380 rpm"', '5\nzero = "left"', "drive.zero", 24, "an angle is wanted"),
    ('"380 rpm"', "5\nfirst = 2", "drive.first", 24, "whole number 0 to 1"),
    ('"380 rpm"', '5\nextra = ["other extreme"]', "drive.extra", 24, "other extreme of what"),
    ('"380 rpm"', '5\nextra = "105 deg"', "drive.extra", 24, "a list is wanted"),
    ("positions = 12", "positions = 0", "drive.positions", 24, "whole number 1 to 100000"),
    ("positions = 12", "positions = 100001", "drive.positions", 24, "whole number 1 to 100000"),
    ("positions = 12", "positions = 12.0", "drive.positions", 24, "whole number is wanted"),
    ("[2, 6]", "[2, 12]", "drive.accelerations[2]", 25, "no position 12; .* from 0 to 11"),
    ("[2, 6]", '[2, "6*"]', "drive.accelerations[2]", 25, "no position 6\\*; name it first, extra"),
    ("[2, 6]", "[2, 2]", "drive.accelerations[2]", 25, "named twice"),
    ("[2, 6]", "[2, 2.5]", "drive.accelerations", 25, "a position is a number, 6, or a text"),
    ("[2, 6]", "2", "drive.accelerations", 25, 'list of positions, .* or "all"'),
    ("mu_l = 0.005", 'mu_l = "1:0"', "scales.mu_l", 27, "cannot be a scale factor"),
    ("mu_l = 0.005", 'mu_l = "5 mm"', "scales.mu_l", 27, "a scale of lengths is wanted"),
    ("mu_l = 0.005", "OA = 60", "scales.OA", 27, '60 m on the sheet .*write "60 mm"'),
    ("mu_l = 0.005", 'mu_l = 0.005\nOA = "60 mm"', "scales.OA", 28,
     "fix the same scale; leave one"),
    ("mu_l = 0.005", "mu_a = -1", "scales.mu_a", 27, "cannot be a scale factor"),
    ('["B"]', '["B", "K"]', "plans.trajectories[2]", 29, '"K" is not a letter of the mechanism'),
    ('["B"]', '["O"]', "plans.trajectories[1]", 29, "does not move; name a moving point"),
    ('["B"]', '["B"]\nvelocities = "turnt"', "plans.velocities", 30, 'did you mean "turned"'),
    ('["B"]', '["B"]\n[hand]\nruler = "5 m"', "hand.ruler", 31, 'is no ruler; write "0.1 mm"'),
    ('"A1"', '"A9"', "sheet 1, format", 31, 'one of "A1", "A1 portrait", "A2"'),
    ('"A1"', '"A1"\nplace = ["speeds"]', "sheet 1, place", 32, '"positions", "given", "special'),
    ('"A1"', '"A1"\nplace = []', "sheet 1, place", 32, "a list of plans is wanted"),
    ("[[sheet]]", "[sheet]", "sheet", 30, r"write \[\[sheet\]\] in double brackets"),
    ('name = "N"', 'nam = "N"', "title_block.nam", 33, 'did you mean "name"'),
    ('name = "N"', 'name = "N"\n[effect]\ngravity = true', "effect", 34, "means nothing here"),
    ('name = "N"', 'name = "N"\n[task]\nkind = "rocker"\nK_v = 1\nstroke = 1\nOB = 1',
     "task.K_v", 36, "number greater than 1"),
    ('name = "N"', 'name = "N"\n[task]\nkind = "rocker"\nK_v = 2\nstroke = -1\nOB = 1',
     "task.stroke", 37, "not greater than 0"),
    ('name = "N"', 'name = "N"\n[task]\nkind = "crank"\nK_v = 2\nstroke = 1\nOB = 1',
     "task.kind", 35, 'did you mean "crank-rocker"'),
    # not TOML at all
    ('"380 rpm"', "380 rpm", "speed", 23, 'in quotes: speed = "380 rpm"'),
    ('"380 rpm"', "39,8", "speed", 23, "decimal sign of a number is a point: 39.8"),
    ('"380 rpm"', "«380 rpm»", "speed", 23, "straight quotes"),
    ("O = [0, 0]\nx", "Д = [0, 0]\nx", "Д", 7, 'stands in quotes: "Д"'),
    ("O = [0, 0]\nx", "O = [0, 0]\nO = [1, 0]\nx", "O", 8, '"O" stands twice in one table'),
    ("O = [0, 0], A", "A = [1, 0], A", "A", 12, '"A" stands twice in one table'),
    ("[plans]", "[drive]", "drive", 28, r"section \[drive\] stands twice"),
    ("[plans]", "[plans", "", 28, "a section is written"),
    ("[plans]", "plans", "", 28, "write key = value"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "key", "line", "words"), CASES)
def test_one_fault(tmp_path, old, new, key, line, words):
    assert GOOD.count(old) >= 1
    faults = faults_of(tmp_path, GOOD.replace(old, new, 1))
    assert [(fault.key, fault.line) for fault in faults] == [(key, line)]
    assert re.search(words, faults[0].message), faults[0].message


def test_all_faults_at_once_in_the_order_of_the_file(tmp_path):
    text = GOOD
    for old, new, *_ in ALL_AT_ONCE:
        assert text.count(old) == 1
        text = text.replace(old, new)
    faults = faults_of(tmp_path, text)
    assert [fault.key for fault in faults] == [key for *_, key in ALL_AT_ONCE]
    assert [fault.line for fault in faults] == sorted(fault.line for fault in faults)


ALL_AT_ONCE = [
    ('"ru"', '"fr"', "language"),
    ('r = "0.1 m"', 'r = "0.1 s"', "lengths.r"),
    ("angle = 90", 'angle = "90 mm"', "frame.v.angle"),
    ("number = 1\n", "number = 1\nmas = 2\n", "link 1, mas"),
    ('B = ["3 r", 0]', 'B = ["3 q", 0]', "link 2, points.B"),
    ('on = "frame"', "on = 8", "link 3, slides.on"),
    ("link = 1\n", "link = 7\n", "drive.link"),
    ('"380 rpm"', '"380 m"', "drive.speed"),
    ("mu_l = 0.005", 'mu_l = "1:"', "scales.mu_l"),
    ('["B"]', '["E"]', "plans.trajectories[1]"),
    ('"A1"', '"A9"', "sheet 1, format"),
    ('name = "N"', 'nome = "N"', "title_block.nome"),
]


def test_the_error_reads_as_path_line_key_message(tmp_path):
    (tmp_path / "scene.toml").write_text(GOOD.replace('"380 rpm"', "-5"), encoding="utf-8")
    with pytest.raises(SceneError) as error:
        read(tmp_path)
    assert str(error.value).startswith(f"{tmp_path / 'scene.toml'}:23: drive.speed: -5 is negative")


@pytest.mark.parametrize("section", ["frame", "link", "drive"])
def test_a_missing_section_is_named(tmp_path, section):
    doc = tomllib.loads(GOOD)
    text = re.sub(rf"\[+{section}\]+\n(?:[^\[\n].*\n)*", "", GOOD)
    assert set(doc) - set(tomllib.loads(text)) == {section}
    fault = next(f for f in faults_of(tmp_path, text) if f.key == section)
    assert fault.message.startswith("it is missing; write a section [")
    assert f"[{section}]" in fault.message


def test_slides_in_a_list_are_counted_from_one(tmp_path):
    old = 'slides = { on = "frame", along = "x", side = "right" }'
    new = 'slides = [\n  { on = 0, along = "x" },\n  { on = 0, along = "w" },\n]'
    (fault,) = faults_of(tmp_path, GOOD.replace(old, new))
    assert (fault.key, fault.line) == ("link 3, slides[2].along", 22)


def test_characters_that_cannot_be_lettered(tmp_path):
    text = GOOD.replace('title = "T"', 'title = "T字"').replace('name = "N"', 'name = "字\\u2603"')
    faults = faults_of(tmp_path, text, missing=lambda text: "".join(set(text) & set("字☃")))
    assert [(fault.key, fault.line) for fault in faults] == [
        ("title", 1),
        ("title_block.name", 33),
        ("title_block.name", 33),
    ]
    assert faults[0].message == 'the character "字" (U+5B57) cannot be lettered; replace it'
    assert {"U+5B57", "U+2603"} == {re.search(r"U\+\w+", f.message)[0] for f in faults[1:]}


def test_letters_are_lettered_too(tmp_path):
    faults = faults_of(tmp_path, GOOD, missing=lambda text: text if text == "B" else "")
    assert [fault.key for fault in faults] == ["link 2, points.B", "link 3, points.B"]


@pytest.mark.parametrize(
    ("data", "line", "words"),
    [
        (b'title = "T"\n# \xff', 2, "not in UTF-8; save it"),
        (b"a = " + b"[" * 100_000, 0, "nested too deep|not TOML"),
        (b"#" * 256_001, 0, "too large: a scene has at most 256 kB"),
        (b"a = " + b"9" * 5000, 0, "cannot be read|not TOML"),
        (b'a = """x\n\n', 3, "not TOML"),
    ],
)
def test_files_that_cannot_be_read(tmp_path, data, line, words):
    (fault,) = faults_of(tmp_path, data)
    assert fault.line == line
    assert re.search(words, fault.message), fault.message


def test_numbers_beyond_all_measure(tmp_path):
    huge = "0x" + "F" * 5000
    text = GOOD.replace("link = 1\n", f"link = {huge}\n")
    text = text.replace("number = 3\n", f"number = {huge}\n")
    faults = faults_of(tmp_path, text.replace('mass = "2 kg"', f"mass = {huge}"))
    assert [fault.key for fault in faults] == [
        "link 2, mass",
        "link (the 3rd in the file), number",
        "drive.link",
    ]
    assert faults[0].message.startswith("2^20000 is too large a number; a mass is wanted")


def test_files_that_are_not_there(tmp_path):
    for path in (tmp_path, tmp_path / "none.toml", tmp_path / "a\0b"):
        with pytest.raises(SceneError) as error:
            read(path)
        (fault,) = error.value.faults
        assert fault.key == ""
        assert re.search("no such file; name a scene|cannot be read", fault.message)


def test_a_folder_in_place_of_the_file(tmp_path):
    (tmp_path / "scene.toml").mkdir()
    with pytest.raises(SceneError, match="this is a folder"):
        read(tmp_path)


def test_synthesis_that_refuses_is_a_fault_of_the_task(tmp_path, monkeypatch):
    from graphic_tmm.mechanism import synthesis

    def refuse(kind, given):
        raise ValueError("the crank is longer than OB; write a smaller stroke")

    monkeypatch.setattr(synthesis, "lengths_found", refuse)
    text = GOOD + '[task]\nkind = "rocker"\nK_v = 2\nstroke = 1\nOB = 1\n'
    (fault,) = faults_of(tmp_path, text)
    assert (fault.key, fault.line) == ("task", 34)
    assert "smaller stroke" in fault.message


def test_a_length_found_by_the_task_may_not_be_named_again(tmp_path):
    task = '[task]\nkind = "rocker"\nK_v = 2\nstroke = 1\nOB = 1\n'
    (fault,) = faults_of(tmp_path, GOOD.replace('r = "0', 'OA = 1\nr = "0') + task)
    assert fault.key == "lengths.OA"
    assert "found by [task] already" in fault.message


WRONG = st.sampled_from(
    [True, -1, 0, 3, 0.5, float("nan"), 10**30, 16**5000, "", "x", "5 kg", "BC", "frame", [], [1],
     [[]], ["a", 1], {}, {"on": 1}, {"x": []}]
)  # fmt: skip


@given(data=st.data())
def test_a_damaged_text_gives_faults_or_a_scene(tmp_path_factory, data):
    text = (SHEETS / "windrower" / "scene.toml").read_text("utf-8")
    start = data.draw(st.integers(0, len(text) - 1))
    end = start + data.draw(st.integers(0, 40))
    middle = data.draw(st.text("[]{}=,\"'\n-#. 1AЖ", max_size=3))
    file = tmp_path_factory.mktemp("damaged") / "scene.toml"
    file.write_text(text[:start] + middle + text[end:], encoding="utf-8")
    try:
        scene = read(file)
    except SceneError as error:
        told = [item.message for item in error.faults]
    else:
        told = [link.number for link in scene.mechanism.links]
    assert told
    assert all(item is not None and item != "" for item in told)


def places(node, path=()):
    items = node.items() if isinstance(node, dict) else enumerate(node)
    for key, value in items:
        yield (*path, key)
        if isinstance(value, (dict, list)):
            yield from places(value, (*path, key))


@pytest.mark.parametrize("name", ["engine", "windrower"])
@given(data=st.data())
def test_any_wrong_value_gives_faults_in_words(name, data):
    doc = tomllib.loads((SHEETS / name / "scene.toml").read_text("utf-8"))
    for _ in range(data.draw(st.integers(1, 3))):
        path = data.draw(st.sampled_from(sorted(places(doc), key=str)))
        node = doc
        for part in path[:-1]:
            node = node[part]
        if data.draw(st.booleans()):
            node[path[-1]] = copy.deepcopy(data.draw(WRONG))
        else:
            del node[path[-1]]
        if not doc:
            return
    parts, found = sections.understand(doc)
    found += [*references.name_faults(doc, lambda text: ""), *checks.contradictions(parts)]
    told = [fault(doc, {}, item) for item in found]
    assert all(item.key and item.message for item in told)
    if not found:
        assert build.scene(parts, "").mechanism.links


@pytest.mark.parametrize(("n", "says"), [(30, f"{10**30}"), (400, "of so large a number")])
def test_a_link_number_of_any_size_is_looked_up(tmp_path: Path, n: int, says: str) -> None:
    text = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")
    path = tmp_path / "scene.toml"
    path.write_text(text.replace('on = "frame"', f"on = {10**n}"), encoding="utf-8")
    with pytest.raises(SceneError, match=f"there is no link {says}"):
        read(path)
