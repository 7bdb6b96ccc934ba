"""`motion` as users call it, against pylinkage with numba: seconds of the processor, whose numbers are right.

    pip install pylinkage==1.3.0 numba
    python tests/benchmarks/motion.py

Both find places, velocities and accelerations of every joint of a four-bar and of a six-bar, at angles that go
evenly round. The judge is an analytic loop of its own. Calls take turns; compared are medians of one run.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from clock import Row, show  # first: it finds the tests' other modules

import graphic_tmm
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Side
from graphic_tmm.scene.records import Scene

COUNTS = {12: 200, 1_000: 30, 1_000_000: 1}
"""How many angles, and how many calls are one measurement."""
SPELL = 3
"""Measurements of one at a time."""
WANTED = {12: 1.0, 1_000: 1.0, 1_000_000: 10.0}
CALL, ROOM = 0.4e-3, 150.0
"""Seconds of a call of 12 angles; megabytes beyond the results at a million angles, for two letters."""
OMEGA = 10.0
C, F = 0.3 + 0j, 0.45 - 0.05j
OA, AB, CB, BG, FG = 0.1, 0.28, 0.22, 0.2, 0.25
PAIRS = (("A", "C", AB, CB, "B"), ("B", "F", BG, FG, "G"))
"""Dyads: the letters they hang on, their lengths, the joint between them, left of the first to the second."""


def scene(dyads: int) -> Scene:
    """Return the four-bar (one dyad) or the six-bar (two)."""
    links = [Link(1, {"O": 0j, "A": OA + 0j})]
    for k, (first, second, near, far, joint) in enumerate(PAIRS[:dyads]):
        side = Side(1, (first, second))
        links.append(Link(2 * k + 2, {first: 0j, joint: near + 0j}, side=side))
        links.append(Link(2 * k + 3, {second: 0j, joint: far + 0j}))
    frame = dict((("O", 0j), ("C", C), ("F", F))[: dyads + 1])
    mechanism = Mechanism(Link(0, frame), tuple(links), Drive(1, OMEGA))
    return Scene("benchmark", "", "en", mechanism)


def judged(dyads: int, angles: Any) -> dict[str, tuple[Any, Any, Any]]:
    """Return place, velocity and acceleration of every joint by closed form."""
    a = OA * np.exp(1j * np.radians(angles))
    still = np.zeros_like(a)
    found = {"A": (a, 1j * OMEGA * a, -(OMEGA**2) * a)}
    found |= {name: (still + at, still, still) for name, at in (("C", C), ("F", F))}
    for first, second, near, far, joint in PAIRS[:dyads]:
        (p, vp, ap), (q, vq, aq) = found[first], found[second]
        d = q - p
        foot = 0.5 + (near**2 - far**2) / (2.0 * np.abs(d) ** 2)
        r = d * (foot + 1j * np.sqrt(near**2 / np.abs(d) ** 2 - foot**2))
        s = r - d
        # of r′ = iω₂r and s′ = iω₃s only the two rates are unknown
        w = _rates(r, s, vq - vp)
        e = _rates(r, s, aq - ap + w[0] ** 2 * r - w[1] ** 2 * s)
        found[joint] = (p + r, vp + 1j * w[0] * r, ap + (1j * e[0] - w[0] ** 2) * r)
    return found


def _rates(r: Any, s: Any, due: Any) -> tuple[Any, Any]:
    """Solve i·x·r − i·y·s = due."""
    area = (r.conjugate() * s).imag
    return (due * s.conjugate()).real / area, (due * r.conjugate()).real / area


def peer(dyads: int, count: int) -> Any:
    """Return pylinkage's linkage, made ready for its compiled loop, at ``count`` steps a turn."""
    from pylinkage import Crank, Ground, RRRDyad
    from pylinkage.simulation import Linkage

    start = judged(dyads, np.zeros(1))
    o = Ground(0.0, 0.0, name="O")
    crank = Crank(anchor=o, radius=OA, angular_velocity=2.0 * np.pi / count, name="A")
    parts = [o, crank]
    joints = {"A": crank.output}
    for first, second, near, far, joint in PAIRS[:dyads]:
        at, spot = start[second][0][0], start[joint][0][0]
        joints[second] = Ground(at.real, at.imag, name=second)
        joints[joint] = RRRDyad(
            joints[first], joints[second], near, far, x=spot.real, y=spot.imag, name=joint
        )
        parts += [joints[second], joints[joint]]
    made = Linkage(parts)
    made.set_input_velocity(crank, omega=OMEGA)
    made.compile()
    return made


def _anew(dyads: int, count: int) -> object:
    """Make a linkage and run it, as one does whose angles are others than those of the last."""
    return peer(dyads, count).step_fast_with_kinematics(iterations=count)


def in_turns(calls: Mapping[str, Callable[[], object]], least: int, rounds: int = 3) -> Any:
    """Median seconds of the processor of calls that take turns; the first round only warms up.

    Each has several calls at a turn: what one leaves to the system's memory is not charged to the next.
    """
    times: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds + 1):
        for name, call in calls.items():
            for _ in range(SPELL):
                start = time.process_time()
                for _ in range(least):
                    call()
                times[name].append((time.process_time() - start) / least)
    return {name: statistics.median(each[SPELL:]) for name, each in times.items()}


def worst(found: Any, due: Any) -> float:
    """How far numbers are off at worst, of the largest that is due."""
    return float(np.max(np.abs(found - due)) / np.max(np.abs(due)))


def rights(dyads: int, name: str) -> list[Row]:
    """Rows of whose numbers are right, at as many angles as there are."""
    count = max(COUNTS)
    angles = np.arange(1, count + 1) * 360.0 / count
    due, rows = judged(dyads, angles), []
    k = graphic_tmm.motion(scene(dyads), angles, exact=True)
    made = peer(dyads, count)
    theirs = made.step_fast_with_kinematics(iterations=count)
    at = {part.name: i for i, part in enumerate(made.components)}
    for joint in ("B", "G")[:dyads]:
        own = (k[joint].place, k[joint].velocity, k[joint].acceleration)
        for what, mine, their, right in zip(
            ("places", "velocities", "accelerations"), own, theirs, due[joint], strict=True
        ):
            other = their[:, at[joint], 0] + 1j * their[:, at[joint], 1]
            off = worst(mine, right)
            says = f"{off:.1e}; pylinkage {worst(other, right):.1e}"
            rows.append(Row(f"{name}, {what} of {joint}, off", says, "≤ 1e-9", off <= 1e-9))
    return rows


def speeds(dyads: int, name: str) -> list[Row]:
    """Rows of how fast both are."""
    rows, mechanism = [], scene(dyads)
    for count, least in COUNTS.items():
        angles = np.arange(1, count + 1) * 360.0 / count
        made = peer(dyads, count)
        found = in_turns(
            {
                "motion": lambda a=angles: graphic_tmm.motion(mechanism, a, exact=True),
                "read": lambda a=angles: graphic_tmm.motion(mechanism, a),
                "by numpy": lambda a=angles: graphic_tmm.motion(
                    mechanism, a, exact=True, fast=False
                ),
                "pylinkage": lambda m=made, n=count: m.step_fast_with_kinematics(iterations=n),
                "made anew": lambda n=count: _anew(dyads, n),
            },
            least,
        )
        ratio = found["pylinkage"] / found["motion"]
        told = ", ".join(f"{key} {1e3 * one:.3g} ms" for key, one in found.items())
        wanted, anew = WANTED[count], found["made anew"] / found["motion"]
        what = f"{name}, {count:,} angles: times as fast as pylinkage"
        rows.append(Row(what, f"{ratio:.2f} ({told})", f"≥ {wanted:g}", ratio >= wanted))
        what = f"{name}, {count:,} angles: as fast as a linkage of pylinkage's made for them"
        rows.append(Row(what, f"{anew:.2f}", f"≥ {wanted:g}", anew >= wanted))
        if count == 12:
            for how, key in (("compiled", "motion"), ("by numpy", "by numpy")):
                what = f"{name}, a call of 12 angles, {how}"
                told = f"{1e3 * found[key]:.3f} ms"
                rows.append(Row(what, told, "≤ 0.4 ms", found[key] <= CALL))
            rows.append(Row(f"{name}, another's first call of 12 angles", first(dyads, angles)))
    return rows


def first(dyads: int, angles: Any) -> str:
    """What the first call takes of a mechanism of other lengths, and what of it the log takes."""
    found = []
    for k in range(9):
        other = scene(dyads)
        assert other.mechanism is not None
        crank, *links = other.mechanism.links
        long = {letter: (1.0 + 0.001 * k) * at for letter, at in crank.points.items()}
        bodies = (replace(crank, points=long), *links)
        other = replace(other, mechanism=replace(other.mechanism, links=bodies))
        seconds = []
        for fast in (False, True):
            start = time.process_time()
            graphic_tmm.motion(other, angles, exact=True, fast=fast)
            seconds.append(time.process_time() - start)
        found.append(seconds)
    log, loop = (1e3 * statistics.median(each) for each in zip(*found, strict=True))
    return f"{log:.1f} ms recorded and run by numpy; then compiled {loop:.2f} ms"


MEMORY = """
import resource, sys
sys.path[:0] = {path!r}
import numpy, motion, graphic_tmm
scene = motion.scene(1)
call = lambda n: graphic_tmm.motion(scene, numpy.linspace(0, 360, n), ["A", "B"], fast={fast})
call(12)
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
k = call(1_000_000)
rise = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1e3
found = [*k.places.values(), *k.velocities.values(), *k.accelerations.values()]
found += [*k.omega.values(), *k.epsilon.values(), k.angles]
print(rise - sum({{id(a): a.nbytes for a in found if a.strides[0]}}.values()) / 1e6)
"""


def memory() -> list[Row]:
    """Rows of what a million angles take beyond the results."""
    rows = []
    for how, fast in (("executed", False), ("compiled", True)):
        text = MEMORY.format(path=sys.path[:3], fast=fast)
        done = subprocess.run(
            [sys.executable, "-c", text], check=True, capture_output=True, text=True
        )
        over = float(done.stdout)
        rows.append(
            Row(f"10⁶ angles of two letters, {how}: beyond the results", f"{over:.0f} MB",
                f"≤ {ROOM:g} MB", over <= ROOM)
        )  # fmt: skip
    return rows


def main() -> None:
    """Print the table."""
    rows = memory()
    try:
        import numba  # noqa: F401
        import pylinkage  # noqa: F401
    except ImportError as error:
        print(f"{error.name} is missing: pip install pylinkage==1.3.0 numba", file=sys.stderr)
    else:
        for dyads, name in ((1, "four-bar"), (2, "six-bar")):
            rows += speeds(dyads, name) + rights(dyads, name)
    show("motion", rows)


if __name__ == "__main__":
    main()
