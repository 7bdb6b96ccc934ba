"""The lines of keys, by hand and against tomllib."""

import tomllib

from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.scene.lines import line_of, locate

TEXT = '''# a comment with [brackets] and "quotes"
title = "x # not a comment"

[frame]
"number" = 6
y = { through = [0, "a ] b"], angle = 'b } c' }  # [no]
'O 1'.a . b = 1

[[link]]
points = { A = [0, 0], B = [1,
    2] }
[[link.slides]]
on = 3

[[link]]
number = 2
slides = [
  # first
  { on = 1 },

  { on = 2, along = "BC" },
]
text = """
two = 2 [lines] ""\\"
"""
raw = \'\'\'
[x]\'\'\'\'
after = 1979-05-27 07:32:00
[link.points]
A = [0, 0]
'''


def test_by_hand():
    tomllib.loads(TEXT)
    lines = locate(TEXT)
    assert lines["title",] == 2
    assert lines["frame",] == 4
    assert lines["frame", "number"] == 5
    assert lines["frame", "y", "angle"] == 6
    assert lines["frame", "O 1", "a", "b"] == 7
    assert lines["link", 0] == 9
    assert lines["link", 0, "points", "B", 1] == 11
    assert lines["link", 0, "slides", 0, "on"] == 13
    assert lines["link", 1] == 15
    assert lines["link", 1, "slides", 1, "along"] == 21
    assert lines["link", 1, "raw"] == 26
    assert lines["link", 1, "after"] == 28
    assert lines["link", 1, "points", "A"] == 30


def test_a_missing_key_falls_back_on_its_table():
    lines = locate("a = 1\n[drive]\nlink = 1\n")
    assert line_of(lines, ("drive", "speed")) == 2
    assert line_of(lines, ("drive", "zero", "point")) == 2
    assert line_of(lines, ("plans",)) == 0


def test_windows_line_ends():
    assert locate("a = 1\r\n[b]\r\nc = [\r\n 1,\r\n 2]\r\n")["b", "c", 1] == 5


KEYS = st.one_of(
    st.from_regex(r"[A-Za-z0-9_-]{1,5}", fullmatch=True), st.text("Дбя .#=[]{},'ab", max_size=4)
)
SCALARS = st.one_of(
    st.integers(-9, 99),
    st.booleans(),
    st.floats(0, 9),
    st.text("ab #[]{}=,\"'\\\n", max_size=6),
)
INLINE = st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(KEYS, inner, max_size=3),
    max_leaves=6,
)
TABLES = st.recursive(
    st.dictionaries(KEYS, INLINE, max_size=3),
    lambda inner: st.dictionaries(
        KEYS, inner | st.lists(inner, min_size=1, max_size=2), max_size=3
    ),
    max_leaves=6,
)


def spell(key, style):
    bare = key and all(c.isascii() and (c.isalnum() or c in "_-") for c in key)
    if bare and style != "quoted":
        return key
    return f"'{key}'" if "'" not in key and style == "quoted" else f'"{key}"'


def value_text(value, draw):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        body = value.replace("\\", "\\\\").replace('"', '\\"')
        if draw(st.booleans()):
            return f'"""{body}"""'
        return '"{}"'.format(body.replace("\n", "\\n"))
    if isinstance(value, list):
        gap = draw(st.sampled_from([" ", "\n", " # x ] } \n\n"]))
        items = f",{gap}".join(value_text(item, draw) for item in value)
        tail = draw(st.sampled_from(["", ","])) if value else ""
        return f"[{gap}{items}{tail}{gap}]"
    if isinstance(value, dict):
        pairs = (f"{spell(k, 'any')} = {value_text(v, draw)}" for k, v in value.items())
        return "{ " + ", ".join(pairs) + " }"
    return str(value)


def is_table(value):
    return isinstance(value, dict)


def are_tables(value):
    return isinstance(value, list) and value != [] and all(map(is_table, value))


def table_text(table, path, draw):
    style = draw(st.sampled_from(["any", "quoted"]))
    text, later = "", ""
    for key, value in table.items():
        name = ".".join(spell(part, style) for part in (*path, key))
        if is_table(value) and draw(st.booleans()):
            later += f"[ {name} ] # {{\n" + table_text(value, (*path, key), draw)
        elif are_tables(value) and draw(st.booleans()):
            for item in value:
                later += f"[[{name}]]\n\n" + table_text(item, (*path, key), draw)
        else:
            text += f"{spell(key, style)} = {value_text(value, draw)}\n"
    return text + later


@st.composite
def documents(draw):
    return table_text(draw(TABLES), (), draw)


def paths(node, path=()):
    if isinstance(node, dict):
        for key, value in node.items():
            yield (*path, key)
            yield from paths(value, (*path, key))
    elif isinstance(node, list):
        for i, value in enumerate(node):
            yield (*path, i)
            yield from paths(value, (*path, i))


@given(documents())
def test_every_path_has_a_line_that_holds_its_key(text):
    doc = tomllib.loads(text)
    lines = locate(text)
    written = text.split("\n")
    for path in paths(doc):
        assert path in lines, (path, text)
        names = [part for part in path if isinstance(part, str)]
        if isinstance(path[-1], str):
            assert names[-1] in written[lines[path] - 1]
    assert set(lines) == set(paths(doc))


@given(st.text("ab=[]{}.,#\"'\\\n 1", max_size=60))
def test_never_raises(text):
    lines = locate(text)
    assert all(0 < line <= text.count("\n") + 1 for line in lines.values())


def test_deep_nesting_is_no_error():
    assert locate("a = " + "[" * 100_000)["a",] == 1
