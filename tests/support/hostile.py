"""Shapes of text that would take a careless parser the square of their size, or all of the stack."""

from __future__ import annotations

from collections.abc import Callable

Shape = Callable[[int], str]


def fill(piece: str, start: str = "", end: str = "") -> Shape:
    """Return a shape: one piece over and over between a beginning and an end."""
    return lambda size: start + piece * max(1, (size - len(start) - len(end)) // len(piece)) + end


def numbered(form: str, start: str = "") -> Shape:
    """Return a shape: pieces in which a number counts, so that no two are alike."""

    def made(size: int) -> str:
        parts, length, k = [start], len(start), 0
        while length < size:
            parts.append(form.replace("#", str(k)))
            length, k = length + len(parts[-1]), k + 1
        return "".join(parts[:-1])

    return made


LINK = "[[link]]\nnumber = 1\n"
SCENES: dict[str, Shape] = {
    "a long key": fill("a", end=" = 1"),
    "a long word": fill("a"),
    "a long word that ends ill": fill("a", end="!"),
    "a long key without value": fill("a", end=" ="),
    "a long key with a word": fill("a", end=" = x"),
    "a long quoted key": fill("a", '"', '" = 1'),
    "a dotted key": fill("a.", end="b = 1"),
    "a dotted key of quoted parts": fill('"a" . ', end="b = 1"),
    "a dotted header": fill("a.", "[", "b]"),
    "a dotted key in a table": fill("a.", "t = {", "b = 1}"),
    "dotted keys": fill("a . ", end="\n"),
    "nested lists": fill("[", "a = "),
    "nested tables": fill("{a=", "a = "),
    "lists side by side": fill("[],", "a = [", "]"),
    "tables": numbered("[t#]\n"),
    "links": fill("[[link]]\n"),
    "sheets": fill("[[sheet]]\n"),
    "links with numbers": numbered("[[link]]\nnumber = #\npoints={A#=[0,0]}\n"),
    "links of one number": fill("[[link]]\nnumber = 1\npoints={A=[0,0]}\n"),
    "loads": numbered("[[load]]\nlink=#\n"),
    "keys": numbered("k# = 1\n"),
    "keys one letter off": numbered("title# = 1\n"),
    "fixed points": numbered("A# = [0, 0]\n", "[frame]\n"),
    "fixed guides": numbered("g# = { through = [0, 0], angle = 0 }\n", "[frame]\n"),
    "lengths": numbered("l# = 1\n", "[lengths]\n"),
    "dotted lengths": numbered("lengths.l# = 1\n"),
    "points": numbered("A# = [0, #]\n", f"{LINK}[link.points]\n"),
    "points at one place": numbered("A# = [0, 0]\n", f"{LINK}[link.points]\n"),
    "slides": fill('{ on = 3, along = "BC" },', f"{LINK}slides = [", "]"),
    "comments": fill("# comment\n"),
    "a comment": fill("#"),
    "blank lines": fill("\n"),
    "spaces": fill(" "),
    "spaces before a sign": fill(" ", "a", "= 1"),
    "spaces before nothing": fill(" ", "a = 1,", "x"),
    "strings": numbered('k# = "x"\n'),
    "a list of strings": fill('"x",', "title = [", "]"),
    "a long string": fill("x", 'title = "', '"'),
    "a long quantity": fill("1", '[drive]\nspeed = "', ' rpm"'),
    "a long unit": fill("m·", '[drive]\nspeed = "1 ', '"'),
    "lines in a string": fill("x\n", 'title = """', '"""'),
    "quotes": fill('"', "title = "),
    "apostrophes": fill("'", "title = "),
    "quotes and spaces": fill('" ', "title = "),
    "backslashes": fill("\\\\", 'title = "', '"'),
    "escapes": fill("\\u0041", 'title = "', '"'),
    "digits": fill("9", "a = "),
    "digits and a comma": fill("9", "a = ", ",1"),
    "decimals": fill("9", "a = 0."),
    "signs of equality": fill("="),
    "commas in braces": fill(", ", "a = {"),
    "letters in braces": fill("д", "a = {"),
    "signs": fill("-", "a = "),
    "positions": fill("1,", "[drive]\naccelerations = [", "1]"),
    "letters": fill('"A",', "[plans]\ntrajectories = [", "]"),
    "words of the title block": numbered('n# = "x"\n', "[title_block]\n"),
    "one key again and again": fill("a = 1\n"),
    "returns": fill("\r"),
    "control characters": fill("\x01"),
}
HEAD = "plan,position,segment,mm,value,unit,x,y\n"
READINGS: dict[str, Shape] = {
    "rows": numbered("velocities,#,pb,17.5,,,,\n", HEAD),
    "one row again and again": fill("velocities,2,pb,17.5,,,,\n", HEAD),
    "quoted rows": numbered('"velocities","#","pb",17.5,,,,\n', HEAD),
    "wrong rows": fill("velocities,2,pb,x,y,z,a,b\n", HEAD),
    "a long cell": fill("a", HEAD),
    "commas": fill(",", HEAD),
    "commas for titles": fill(","),
    "one title again and again": fill("plan,"),
    "a long title": fill("plan"),
    "titles": numbered("t#,"),
    "quotes": fill('"', HEAD),
    "quotes that are not closed": fill('"a\n', HEAD),
    "quotes within": fill('a"b"c,\n', HEAD),
    "a quote that is not closed": fill("a\n", f'{HEAD}"'),
    "comments": fill("# c\n"),
    "blank lines": fill("\n"),
    "spaces": fill(" ", HEAD),
    "digits": fill("9", f"{HEAD}velocities,1,pb,"),
    "digits and spaces": fill(" ", f"{HEAD}velocities,1,pb,9", "x"),
    "signs": fill("-", f"{HEAD}velocities,1,pb,"),
    "points": fill(".", f"{HEAD}velocities,1,pb,1"),
    "a long unit": fill("m2", f"{HEAD}velocities,1,pb,,1,"),
    "stars": fill("*", f"{HEAD}velocities,1,pb,,1 a", "a,m"),
    "powers": fill("^-", f"{HEAD}velocities,1,pb,,1 a", "a,m"),
    "a title with spaces": fill(" ", "x", "mm\n"),
    "a title with brackets": fill("(", "x", "mm\n"),
    "lines sep=": fill("sep=,\n"),
    "returns": fill("\r", HEAD),
    "accents": fill("́", "a"),
}
