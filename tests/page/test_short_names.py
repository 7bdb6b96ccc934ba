"""The page's program with short names: another parser reads the same program, and the same of the browser's."""

from __future__ import annotations

import pytest
from support.browser import TOOLS, tool
from support.scripts import run

from graphic_tmm.page.page import program_parts, script
from graphic_tmm.page.short_names import shortened

COMPARED = """
import { createRequire } from "node:module";
const needed = createRequire(asked.tools + "/");
const acorn = needed("acorn"), scopes = needed("eslint-scope");
const options = { ecmaVersion: 2022, sourceType: "module", ranges: true };
const [long, short] = asked.programs.map((code) => acorn.parse(code, options));
const through = (tree) => scopes.analyze(tree, options).globalScope.through;
const beyond = (tree) => [...new Set(through(tree).map((one) => one.identifier.name))];
const LEFT = new Set(["start", "end", "range", "raw", "shorthand"]);
const names = [new Map(), new Map()], unlike = [];
const bound = (from, to) => alike(0, from, to) && alike(1, to, from);
const alike = (k, from, to) => names[k].has(from) ? names[k].get(from) === to : names[k].set(from, to);
function compare(a, b, member) {
  if (a === null || typeof a !== "object") return a === b || unlike.push([a, b]);
  if (a.type !== b?.type || a.length !== b.length) return unlike.push([a.type, b?.type]);
  if (a.type === "Identifier") {
    return (member ? a.name === b.name : bound(a.name, b.name)) || unlike.push([a.name, b.name]);
  }
  for (const key of Object.keys(a)) {
    if (!LEFT.has(key)) compare(a[key], b[key], (key === "key" || key === "property") && !a.computed);
  }
}
compare(long, short, false);
tell({ unlike: unlike.slice(0, 9), beyond: [beyond(long), beyond(short)], names: names[0].size });
"""
PIECES = """
const whole = { given: 1, taken(given) { return `${given}: ${[given].map((one) => `${one}`)}`; } };
const quoted = /given["'`]/.test("given") ? whole.given : `given`;
class Kept { given = 2; static taken = 3; get twice() { return 2 * this.given; }
* each(given = whole) { yield given; } }
function *rows({ given, other: taken = 4, ...rest }, [first, , second]) {
yield { given, taken, rest }; yield first*second; }
let a, b = 1, given = a - -b + +b;
for (const { given: own } of [whole]) outer: for (;;) { if (own) break outer; }
try { window.given = given / 2 / b; } catch (fault) { throw fault; }
const window_ = (window) => ({ window, given, [given]: given ? a : b });
"""
"""Where names stand that are not bindings, and bindings that do not look so."""


def compared(long: str, short: str) -> dict[str, object]:
    tool("acorn")
    tool("eslint-scope")
    found: dict[str, object] = run(COMPARED, {"tools": str(TOOLS), "programs": [long, short]})
    return found


@pytest.mark.parametrize("further", [(), ("practice", "own", "live", "accuracy")])
def test_the_program_is_the_same_but_for_its_names(further):
    long, short = script(*further), shortened(program_parts(*further))
    found = compared(long, short)
    assert found["unlike"] == []
    assert sorted(found["beyond"][0]) == sorted(found["beyond"][1])
    assert len(short) < 0.8 * len(long)


def test_members_keys_and_quoted_words_keep_their_names():
    found = compared(PIECES, shortened([PIECES]))
    assert found["unlike"] == []
    assert found["beyond"] == [["window"], ["window"]]


def test_a_name_that_two_modules_share_is_shortened_alike():
    assert shortened(["const made = 1;\n", "tell(made);\n"]) == "const a=1;tell(a);"


def test_remarks_and_blanks_go_where_signs_stay_what_they_are():
    code = "/* of it */ let more = 1 - -more; // by one\nlet text = 'a  /* b */';\n"
    assert shortened([code]) == "let a=1- -a;let b='a  /* b */';"
