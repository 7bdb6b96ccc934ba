"""What the package finds of a random mechanism, against the judge of all links at once."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import graphic_tmm
from graphic_tmm.page.practice.pack import Packing
from graphic_tmm.page.practice.tasks import sheet_row
from support.benches import Packed, numbers, worked
from support.boards import in_usual_size
from support.free_bodies import Judge, State
from support.free_forces import Statics, statics
from support.random_mechanisms import Random

PLANS: tuple[Any, ...] = ("positions", "velocities", "accelerations", "forces")
LIMITS = {"places": 1e-12, "velocities": 1e-9, "accelerations": 1e-9, "omega": 1e-9, "epsilon": 1e-9,
          "forces": 1e-8, "balance": 1e-8, "power": 1e-12}  # fmt: skip
"""How far results may be off, of the largest of their kind."""


def ways(drawn: Random, count: int) -> list[float]:
    """Ways of the first drive spread over those that were walked, both ends among them."""
    row = [way for way, _ in drawn.walked]
    return [row[round(k * (len(row) - 1) / (count - 1))] for k in range(count)]


def parameter(drawn: Random, way: float) -> float:
    """Where `motion` is asked: degrees of a turn, else m."""
    coordinate = drawn.coordinates(way)[0]
    return math.degrees(coordinate) if drawn.judge.drives[0].kind == "turn" else coordinate


def errors(
    drawn: Random,
    scene: Mapping[str, Any],
    row: Sequence[float],
    plans: tuple[Any, ...] = PLANS,
    zero: float = 0.0,
    loaded: Callable[[float, State], Judge] | None = None,
) -> dict[str, float]:
    """How far all that `motion` returns is off, of the largest of its kind; NaN counts as without end.

    ``row``: the ways at which it is asked; ``zero``: that of the zero position; ``loaded``: a judge of
    the loads at a way, where they vary with more than the turn of the crank.
    """
    found = graphic_tmm.motion(
        graphic_tmm.read(scene), [parameter(drawn, way) for way in row], exact=True, plans=plans
    )
    worst: dict[str, float] = defaultdict(float)

    def note(kind: str, off: float, largest: float) -> None:
        share = off / largest if largest else off
        worst[kind] = max(worst[kind], share if share == share else math.inf)

    for k, way in enumerate(row):
        state = drawn.solved(way)
        fast = _most(state.point(*key)[1] for key in found.velocities)
        least_of = {"places": 0.0, "velocities": 0.0, "accelerations": fast**2 / drawn.scale}
        for part, kind in enumerate(("places", "velocities", "accelerations")):
            values = getattr(found, kind)
            due = {key: state.point(*key)[part] for key in values}
            largest = max(_most(due.values()), least_of[kind])
            note(kind, _most(values[x][k] - due[x] for x in due), largest)
        rate = max(abs(drive.rate) / _way(drawn, drive.kind) for drive in drawn.judge.drives)
        for kind, turns, least in (
            ("omega", state.omega, rate),
            ("epsilon", state.epsilon, rate**2),
        ):
            values = getattr(found, kind)
            off = _most(values[n][k] - turns[n] for n in values)
            note(kind, off, max(least, _most(turns.values())))
        if "forces" in plans and clear(drawn, state):
            judge = loaded(way, state) if loaded is not None else drawn.judge
            _forces(judge, state, way - zero, found, k, note)
    return dict(worst)


def _most(values: Iterable[complex]) -> float:
    """The largest length; NaN where one is."""
    return float(np.max(np.abs([0.0, *values])))


def _way(drawn: Random, kind: str) -> float:
    return 1.0 if kind == "turn" else drawn.scale


def clear(drawn: Random, state: State) -> bool:
    """Whether every load against a motion knows its sense."""
    fast = max(abs(state.point(x, n)[1]) for n, x in _points(drawn))
    turn = max(map(abs, state.omega.values()))
    for load in drawn.scene.get("load", ()):
        way = load.get("direction", "against velocity" if "point" in load else "")
        if (
            way == "against velocity"
            and abs(state.point(load["point"], load["link"])[1]) < 1e-3 * fast
        ):
            return False
        if way == "against rotation" and abs(state.omega[load["link"]]) < 1e-6 * turn:
            return False
    return True


def _points(drawn: Random) -> list[tuple[int, str]]:
    return [(body.number, x) for body in drawn.judge.words.bodies for x in body.points]


def _forces(judge: Judge, state: State, way: float, found: Any, k: int, note: Any) -> None:
    """Reactions and what each drive needs."""
    turned = math.degrees(way) * math.copysign(1.0, judge.drives[0].rate)
    due = statics(judge, state, turned)
    note("power", abs(due.power), 1.0)
    names = reactions(judge, due, found.forces)
    for name, values in found.forces.items():
        note("forces", abs(values[k] - names[name]), due.largest)
    first, *further = due.drives
    needs = {"forces": first, "lever": first}
    for d, p in zip(judge.words.drives[1:], further, strict=True):
        needs |= {str(d["link"]): p, f"{d['link']}_lever": p}
    assert {name[len("P_bal_") :] for name in found.balance} == set(needs)
    for name, values in found.balance.items():
        arm = judge.size if name.startswith("M") else 1.0
        note("balance", abs(values[k] - needs[name[len("P_bal_") :]]), due.largest * arm)


def reactions(judge: Judge, due: Statics, names: Iterable[str]) -> dict[str, complex]:
    """What each of the names stands for, N.

    Every pair has one of its two reactions among them, but a driving rod and its cylinder: between them is what
    the drive needs.
    """
    by_name = {name.replace(",", ""): name for name in names}
    of = {f"R{i}{j}": force for (i, j), force in due.reactions.items()}
    body = judge.words.bodies
    rods = {
        frozenset((body[drive.tip.body].number, body[drive.line.body].number))
        for drive in judge.drives
        if drive.kind == "rod"
    }
    for i, j in due.reactions:
        told = {f"R{i}{j}", f"R{j}{i}"} & by_name.keys()
        assert told or {i, j} in rods, f"no reaction between {i} and {j} in {sorted(by_name)}"
    return {name: of[own] for own, name in by_name.items()}


def page_is_right(scene: Mapping[str, Any], folder: Path) -> None:
    """See that the page's benches, worked by node, have of every step what Python has of it."""
    places = [{"format": "A1", "place": ["positions", "velocities", "accelerations"]}]
    sheet = in_usual_size(graphic_tmm.read({**scene, "sheet": places}), exact=True)
    row = sheet_row(sheet)
    assert row is not None
    packing = Packing(sheet, row, ())
    packed = Packed("random", sheet, packing, packing.data(()), packing.program())
    (answer,) = worked([packed], {}, folder, work=True)
    compared = 0
    for task, exact in ((one["task"], one["exact"]) for one in answer["worked"]):
        for step in packing.steps:
            if row.there(step.it, task["at"]):
                due = numbers(row.reading[step.it], task["at"])
                off = np.abs(np.subtract(exact[str(step.it.slot)], due))
                assert np.all(off <= 1e-9 * max(1.0, np.abs(due).max())), (step.it, task["at"])
                compared += 1
    assert compared > 300
