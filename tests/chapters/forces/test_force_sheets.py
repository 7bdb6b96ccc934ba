"""A force sheet and a lever are recomputed from the sheet alone: from the SVG that a reader holds in his hands.

Nothing of the log is asked. What a stroke tells has six figures, a length two decimals; what is printed has the
figures that it has. So each tolerance is what those digits leave open.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from itertools import pairwise

import pytest
from support.each import each
from support.force_views import LOADED, loaded_drawing, views_of
from support.gallery import drawn
from support.loaded import weighed
from support.mechanisms import sample
from support.sheet_reader import (
    Told,
    View,
    letters,
    lines,
    numbers_of,
    plain,
    result,
    signed,
    views,
    worked,
    written,
)

from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.write.svg import svg

FIGURES, TWO = 1e-5, 0.005
"""What is left open of a quantity with six figures, of itself, and of a length with two decimals, mm."""
SHORT = 0.5
"""A side that is shorter, mm, is a point of its polygon."""

BALANCED = [name for name in LOADED if name != "hand-clamp"]
"""Of the other one the force at its tool is sought (`test_tool.py`)."""


def sheet(work: Drawn) -> dict[str, View]:
    """The force views of a drawing as they are written to a file, one beside the other."""
    placed = tuple(view.moved(complex(600.0 * k)) for k, view in enumerate(views_of(work)))
    return views(svg(Sheet("s", "s", "A1", 841.0, 594.0, placed, work.scene.language)))


def mu_of(view: View, letter: str) -> float:
    text = next(w for w in view.words if w.startswith(f"μ_{letter}") and " = " in w)
    return worked(text.partition(" = ")[2].split(" ")[0]).value


def moment(one: Told) -> tuple[float, float]:
    """The moment of a force by its arm, N·mm, and what its figures leave open."""
    force, arm = one.number("value"), one.number("arm")
    return force * arm, abs(force) * TWO + abs(force * arm) * FIGURES


def summed(strokes: list[Told], mu: float) -> tuple[float, float]:
    """The moments of forces and couples, N·m."""
    total = open_ = 0.0
    for one in strokes:
        turns, off = moment(one) if "arm" in one.data else (one.number("value") / mu, 0.0)
        total += turns * mu
        open_ += (off + abs(turns) * FIGURES) * mu
    return total, open_


def check_group(view: View, told: View) -> int:
    """Every ΣM = 0 about a pin of a group: what it gives is what its loads, arms and couples come to."""
    mu, checked, heading = mu_of(view, "l"), 0, ""
    loads = [s for s in view.strokes if "value" in s.data and "link" in s.data]
    for line in lines(told):
        if line.startswith("ΣM"):
            heading = line
            continue
        sought = plain(line.split(" ")[0])
        links = re.search(r"\^\(+([\d,]+)\)+ =", heading)
        if not (sought.endswith("^t") and links) or heading.startswith("ΣM_W"):
            continue
        printed = result(line)
        reaction = next((s for s in loads if s.data["segment"] == sought), None)
        own = [s for s in loads if s.data["link"] in links[1].split(",")]
        own = [s for s in own if not s.data["segment"].endswith("^t")]
        total, open_ = summed(own, mu)
        if reaction is None:  # too short for its polygon: a point
            continue
        # R·l by its sign along the line it is drawn for: the arrow turns against the loads
        held, off = moment(reaction)
        tolerance = open_ + off * mu + printed.half * abs(reaction.number("arm")) * mu
        assert abs(total + held * mu) <= tolerance, line
        assert abs(abs(printed.value) - reaction.number("value")) <= printed.half + FIGURES * abs(
            printed.value
        )
        checked += 1
    return checked


def check_driver(view: View, told: View) -> int:
    mu, checked = mu_of(view, "l"), 0
    loads = [s for s in view.strokes if "value" in s.data and "link" in s.data]
    for line in lines(told):
        if not re.match(r"[PM]_(b|ур) = ", line):
            continue
        printed = result(line)
        own = [s for s in loads if s.data["segment"] not in ("Pb", "Mb")]
        total, open_ = summed(own, mu)
        if line.startswith("M"):
            held = sum(s.number("value") for s in loads if s.data["segment"] == "Mb")
            assert abs(held - printed.value) <= printed.half + FIGURES * abs(printed.value)
            assert abs(total + held) <= open_ + printed.half
        else:
            balance = next((s for s in loads if s.data["segment"] == "Pb"), None)
            if balance is None:
                continue
            held, off = moment(balance)
            tolerance = open_ + off * mu + printed.half * abs(balance.number("arm")) * mu
            assert abs(total + held * mu) <= tolerance, line
            assert held * printed.value >= 0.0, line
        checked += 1
    return checked


def check_lever(view: View, told: View) -> None:
    """ΣM_p = 0: forces by their arms, converted couples, what balances them at the crank pin."""
    forces = [s for s in view.strokes if "arm" in s.data]
    couples = [s for s in view.strokes if s.data.get("unit") == "N·mm"]
    total, open_ = 0.0, 0.0
    for one in forces:
        turns, off = moment(one)
        total, open_ = total + turns, open_ + off
    for one in couples:
        total += one.number("value")
        open_ += abs(one.number("value")) * FIGURES
    assert abs(total) <= open_
    if forces:
        line = next(text for text in lines(told) if re.match(r"P_(b|ур)\S* = ", text))
        printed = result(line)
        balance = [s for s in forces if s.data["segment"] == "Pbl"]
        for one in balance:
            assert abs(abs(printed.value) - one.number("value")) <= printed.half + FIGURES * abs(
                printed.value
            )
            assert one.number("arm") * printed.value >= 0.0, line


def called(letter: str) -> str:
    """What machines call a letter of a sheet in either language."""
    told = plain(letter.replace("P_ур^Ж", "Pbl").replace("P_b^Zh", "Pbl"))
    told = re.sub(r"\((.+)\)$", r"\1", told) if "_(" in letter else told
    return told.replace("Pур", "Pb").replace("Mур", "Mb").replace("и", "i")


def senses(view: View) -> dict[str, int]:
    """The sense in which what acts on a figure is drawn, by its name: +1 counter-clockwise."""
    found = {}
    for one in view.strokes:
        key = "arm" if "arm" in one.data else "value"
        if "value" in one.data and "segment" in one.data and one.number(key):
            found[one.data["segment"]] = 1 if one.number(key) > 0 else -1
    return found


def _turning(view: View) -> list[Told]:
    """The couples that are drawn."""
    return [s for s in view.strokes if s.data.get("unit") == "N·m" and s.number("value")]


def about_special(view: View) -> dict[str, int]:
    """The senses about a special point, as arrows and arms are drawn: +1 counter-clockwise."""
    arms = {s.data["segment"]: s for s in view.strokes if "mm" in s.data}
    found = {}
    for force in (s for s in view.strokes if s.data.get("segment", "")[:1] in "PGFR"):
        name = force.data["segment"]
        one = arms.get(f"h{name}^W")
        if one is not None and abs(one.end - one.start) >= SHORT:
            turns = ((one.end - one.start).conjugate() * force.way).imag
            found[name] = 1 if turns > 0 else -1
    return found


def check_letters(view: View, told: View) -> int:
    """Every ΣM = 0 holds by its letters with what is printed, signs as what acts is drawn.

    What is sought keeps its own sign: where it is negative it is drawn against the sign of its term.
    """
    checked, written_out = 0, lines(told)
    exact = {figure for text in view.words for figure in re.findall(r"(?:μ_\w|k) = (\S+)", text)}
    known = {worked(figure.rstrip(",")).value for figure in exact}
    arrows = senses(view)
    couples = {s.data["segment"]: arrows[s.data["segment"]] for s in _turning(view)}
    sizes = {text.split(" ")[0]: result(text) for text in written_out if not text.startswith("ΣM")}
    for name, size in sizes.items():
        assert size.value >= 0.0 or re.match(r"[PM]_(ур|b)|R.*\^[τtnW]$", name), name
    for heading, given in pairwise(written_out):
        if not (heading.startswith("ΣM") and heading.endswith(" = 0")):
            continue
        by_letters = heading.split(" = ")[1].replace("|", "")  # sizes are put in
        sought, figures = given.split(" = ")[:2]
        names = letters(by_letters)
        assert names.count(sought) == 1, heading
        others = [name for name in names if name != sought]
        numbers = numbers_of(re.sub(r"^0(?=/|$)", "", figures))
        assert len(others) == len(numbers), (heading, given)
        put = dict(zip(others, numbers, strict=True))
        for name in put.keys() & sizes.keys():  # what is printed is what is put in
            assert worked(put[name]).value == abs(sizes[name].value), name
        size = re.search(r" = (\S+) \S+$", given)
        assert size is not None, given
        put[sought] = size[1]
        left = worked(written(by_letters, put), known)
        largest = max(abs(worked(written(term, put)).value) for term in _terms(by_letters))
        assert abs(left.value) <= left.half + FIGURES * largest, heading
        against = -1 if size[1].startswith("−") else 1
        special = heading.startswith("ΣM_W")
        turns = {**couples, **about_special(view)} if special else arrows
        for term, factors in signed(by_letters):
            sign = term * (against if sought in factors else 1)
            back = "−" if any("_(−" in name for name in factors) else ""  # the other of a pair
            drawn_as = {turns[back + name] for name in map(called, factors) if back + name in turns}
            assert drawn_as <= {sign}, (heading, factors)
        checked += 1
    return checked


def _terms(text: str) -> list[str]:
    return ["·".join(names) for _, names in signed(text)]


def check_arms(view: View, ruler: float) -> int:
    """An arm as it is drawn is as long as it tells, and turns the way that its force tells."""
    checked = 0
    forces: Mapping[str, Told] = {s.data["segment"]: s for s in view.strokes if "arm" in s.data}
    for one in view.strokes:
        name = one.data["segment"]
        if "mm" not in one.data or not name.startswith("h") or name[1:] not in forces:
            continue
        force = forces[name[1:]]
        long = abs(one.end - one.start)
        assert abs(long - one.number("mm")) <= ruler / 2 + TWO + 0.002
        turns = ((one.end - one.start).conjugate() * force.way).imag
        assert abs(turns - force.number("arm")) <= ruler / 2 + long * 2e-3, name
        checked += 1
    return checked


def check_polygon(view: View) -> None:
    """Its sides close it."""
    sides = [s for s in view.strokes if s.pen == "main"]
    equation = next(w for w in view.words if w.endswith("= 0"))
    missing = equation.count(" + ") + 1 - len(sides)
    assert missing >= 0
    total = sum(s.number("mm") * s.way for s in sides)
    # a way is told by ends to 0.001 mm
    open_ = sum(TWO + s.number("mm") * 0.0015 / abs(s.end - s.start) for s in sides)
    assert abs(total) <= open_ + missing * SHORT


def check_printed(told: View, exact: list[float]) -> int:
    """Every printed calculation comes to its printed result; ``exact``: the scale factors in it."""
    checked = 0
    for line in lines(told):
        *letters, figures, _ = line.split(" = ")
        figures = re.sub(r"(\d) (мм|Н/мм|mm|N/mm)", r"\1", figures)
        if not letters or re.search(r"[^\W\d_]", figures):
            continue
        names = [name for name in re.split(r"[·/()|]", letters[-1]) if name.strip("− ")]
        numbers = re.findall(r"\d[\d,.]*", figures)
        if len(names) == len(numbers):
            named = zip(names, numbers, strict=True)
            exact = [*exact, *(worked(x).value for name, x in named if name == "k" or "μ" in name)]
        printed, worked_out = result(line), worked(figures, exact)
        half = printed.half + FIGURES * abs(printed.value)
        assert abs(printed.value - worked_out.value) <= half + worked_out.half, line
        checked += 1
    return checked


def check(work: Drawn) -> int:
    found, ruler, checked = sheet(work), work.hand.ruler or 0.0, 0
    for name, view in found.items():
        kind, _, rest = name.partition("-")
        if kind in ("group", "lever"):
            beside = f"equations-{rest}" if kind == "group" else f"equations-lever-{rest}"
            checked += check_letters(view, found[beside])
        told = found.get(f"equations-{rest}") or found.get(f"equations-lever-{rest}")
        if kind == "group":
            assert told is not None
            checked += check_arms(view, ruler)
            driver = rest.count("-") == 1
            checked += (check_driver if driver else check_group)(view, told)
        elif kind == "forces":
            check_polygon(view)
        elif kind == "lever":
            checked += check_arms(view, ruler)
            check_lever(view, found[f"equations-lever-{rest}"])
        elif kind == "equations":
            figure, plan = found.get(f"group-{rest}"), found.get(f"forces-{rest}")
            exact = [mu_of(figure, "l")] if figure is not None else []
            checked += check_printed(view, exact + ([mu_of(plan, "F")] if plan is not None else []))
    return checked


@each("name", BALANCED)
def test_the_force_sheets_of_a_scene_are_recomputed_from_themselves(name: str) -> None:
    assert check(drawn(name)) >= 8


@pytest.mark.slow
def test_those_of_random_loaded_mechanisms_too(many: Callable[[int, int], int]) -> None:
    for k, one in enumerate(sample(many(16, 5), seed=97, dyads=(1, 3))):
        way = {
            "turned": bool(k % 2),
            "couples": ("moment", "pair")[k % 3 == 0],
            "balance": ("force", "moment")[k % 4 == 0],
        }
        work = loaded_drawing(weighed(one, k), one, ruler=0.1, **way)
        check(work)


def test_a_figure_that_was_changed_is_found() -> None:
    work = drawn("lever")
    found = sheet(work)
    view, told = found["group-2-3-4"], found["equations-2-3-4"]
    check_group(view, told)

    def off(one: Told) -> Told:
        arm = f"{one.number('arm') + 1.0:.2f}"
        return one._replace(data={**one.data, "arm": arm})

    wrong = tuple(off(s) if s.data["segment"] == "Pi2" else s for s in view.strokes)
    with pytest.raises(AssertionError):
        check_group(view._replace(strokes=wrong), told)
    exact = [mu_of(view, "l"), mu_of(found["forces-2-3-4"], "F")]
    assert check_printed(told, exact)
    larger = re.compile(r"(?<=·)(\d+)(?=,\d)")
    words = tuple(
        larger.sub(lambda number: str(int(number[1]) + 2), word, count=1)
        if word.startswith("R₁₂^τ")
        else word
        for word in told.words
    )
    assert words != told.words
    with pytest.raises(AssertionError):
        check_printed(told._replace(words=words), exact)


def test_a_sign_against_its_arrow_is_found() -> None:
    found = sheet(drawn("lever"))
    view, told = found["lever-4"], found["equations-lever-4"]
    assert check_letters(view, told) == 1

    def changed(old: str, new: str) -> View:
        words = tuple(word.replace(old, new) for word in told.words)
        assert words != told.words
        return told._replace(words=words)

    for wrong in (
        changed("− M_и2′", "+ M_и2′"),  # by letters another sense than by figures
        changed("= 6306 ", "= −6306 "),  # a sign in the letter too
        changed("= 6306 ", "= 6307 "),  # another size than is put in
    ):
        with pytest.raises(AssertionError):
            check_letters(view, wrong)


def test_the_difference_of_both_methods_is_that_of_the_printed_sizes() -> None:
    for name in BALANCED:
        found = sheet(drawn(name)).values()
        assert any(word.startswith("Δ = ") for view in found for word in view.words)
        for view in found:
            texts = [word for word in view.words if word.startswith("Δ = ")]
            for text in texts:
                both = next(word for word in view.words if re.match(r"[PM]_(ур|b)\d* = .*, ", word))
                first, second = (result(part) for part in both.split(", "))
                apart = worked(text.split(" ")[2])
                percent = 100.0 * abs((first.value - second.value) / first.value)
                open_ = 100.0 * (first.half + second.half) / abs(first.value)
                assert abs(percent - apart.value) <= apart.half + open_


def test_each_scale_of_lengths_has_one_letter() -> None:
    """What is detached is not to the scale of the plan of positions, so its factor has another letter."""
    for name in ("lever", "crank-press"):
        found = sheet(drawn(name))
        told = {
            (letter, value)
            for view in found.values()
            for word in view.words
            for letter, value in re.findall(r"^(μ_l\S*) = ([\d,.]+)", word)
        }
        assert len({letter for letter, _ in told}) == len(told)
        lever = next(v for k, v in found.items() if k.startswith("equations-lever"))
        letters = set(re.findall(r"μ_l\w*", " ".join(lever.words)))
        assert letters == {"μ_l"}
        assert letters.isdisjoint({letter for letter, _ in told})
