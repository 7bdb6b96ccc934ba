"""Diagrams of a slider by chords and a pole distance, and a cam's follower, as a student draws them."""

from __future__ import annotations

import numpy as np

from support.flywheels import along, smooth
from support.students.drawing import Student
from support.students.machines import CALCULATED, slider_crank_plans
from support.students.records import CAM, D, Machine, P, V

SLIDER, TURN = "S", 160.0


def chords(s: Student) -> None:
    """Draw S from the positions, V from its chords, a from those of V; μ follow from the pole distances."""
    n = s.machine.positions
    start = s.pages[0].points[P, "B"].real
    paths = []
    for k, page in enumerate(s.pages):
        s.k, s.page = k, page
        take = s.take(D, "S", "ordinate", factor=1.0, sense=1.0, start=start, ago=0)
        path = s.signed("s_B", s.pages[k - take["ago"]].points[P, "B"].real - take["start"])
        high = take["factor"] * take["sense"] * path * s.mu[P] / s.mu["S"]
        paths.append(high)
        page.write(D, "S", s.signed("diagrams S", high))
    rows = np.array(paths)
    for name, pole in (("V", "H_V"), ("a", "H_a")):
        rows = _differentiated(s, name, pole, rows)
    assert rows.size == n


def _differentiated(s: Student, name: str, pole: str, rows: np.ndarray) -> np.ndarray:
    """Return the ordinates of the next diagram: rays from its pole along the chords, a curve, its ordinates."""
    step = s.given["L"] / rows.size
    middles = []
    for k in range(rows.size):
        s.k, s.page = k, s.pages[k]
        take = s.take(D, name, "chord", pole=pole, ago=0, sense=1.0, end=False, factor=1.0,
                      reach=s.given[pole])  # fmt: skip
        rise = rows[(k + 1 - take["ago"]) % rows.size] - rows[(k - take["ago"]) % rows.size]
        ray = s.ray(f"chord {name}", complex(step, rise))
        named = take["pole"] != pole
        reach = s.opened(s.given[take["pole"]] if named else take["reach"])
        middles.append(take["factor"] * take["sense"] * reach * ray.imag / ray.real)
    steps = [one for one in s.steps if (one.plan, one.name) == (D, name)]
    high = np.array(middles)
    # the curve through the middles, read halfway between them
    curve = np.roll(along(high, smooth(high), 2)[1::2], 1)
    if s.mind(steps[0]).get("end"):
        curve = high
    for k, page in enumerate(s.pages):
        s.k, s.page = k, page
        page.write(D, name, s.signed(f"diagrams {name}", float(curve[k])))
    return np.asarray(curve)


def charted(s: Student) -> None:
    slider_crank_plans(s, accelerated=False)


OMEGA = 8 * np.pi
MU_T = 2 * np.pi / OMEGA / TURN
CHARTED = Machine(
    {P: 0.0025, V: 0.05, "S": 0.005, "D.S": 0.005, "D.V": 0.005 / MU_T / 25.0,
     "D.a": 0.005 / MU_T**2 / 25.0 / 20.0},
    {"OA": 60.0, "AB": 240.0, "AS2": 80.0, "omega": OMEGA, "L": TURN, "H_V": 25.0, "H_a": 20.0},
    (), charted, CALCULATED, ("OA", "AB"), 8, chords,
)  # fmt: skip


def cam(s: Student) -> None:
    """Draw one position of the follower's diagrams: a sine rise, a cosine return, the pressure angle."""
    rise, fall, parts = (s.given[name] for name in ("rise", "fall", "parts"))
    k = s.k
    take = s.take(CAM, "φ", "phase", rise=rise, fall=fall, count=k, radian=np.pi / 180,
                  parts=parts)  # fmt: skip
    law = s.take(CAM, "S", "law", rise="sine", fall="cosine", stroke="stroke", turned=False)
    if k <= parts:
        phase, u, name = take["rise"] * take["radian"], take["count"] / take["parts"], law["rise"]
        s_, v_, a_ = LAWS[name](u)
    else:
        phase, u, name = (
            take["fall"] * take["radian"],
            (take["count"] - parts - 1) / take["parts"],
            law["fall"],
        )
        s_, v_, a_ = LAWS[name](u if law["turned"] else 1 - u)
        v_ = v_ if law["turned"] else -v_
    stroke = s.given[law["stroke"]]
    one = s.take(CAM, "dS", "derivative", factor=1.0, power=1, sense=1.0, mu="D.dS")
    two = s.take(CAM, "ddS", "derivative", factor=1.0, power=2, sense=1.0, mu="D.ddS")
    path = stroke * s_
    speed = one["factor"] * one["sense"] * stroke * v_ / phase ** one["power"]
    bend = two["factor"] * two["sense"] * stroke * a_ / phase ** two["power"]
    s.page.write(CAM, "S", s.signed("cam S", path / s.mu["D.S"]))
    s.page.write(CAM, "dS", s.signed("cam dS", speed / s.mu[one["mu"]]))
    s.page.write(CAM, "ddS", s.signed("cam ddS", bend / s.mu[two["mu"]]))
    take = s.take(
        CAM, "pressure", "pressure", radius="r0", offset=1.0, path=1.0, of="dS", square=True,
        legs=1,
    )  # fmt: skip
    e = take["offset"] * s.given["e"]
    low = (
        np.sqrt(s.given[take["radius"]] ** 2 - e**2) if take["square"] else s.given[take["radius"]]
    )
    drawn = {"dS": speed, "ddS": bend, "S": path}[take["of"]] - e
    legs = (low + take["path"] * path, drawn)[:: take["legs"]]
    way = s.ray("pressure", complex(*legs))
    angle = np.degrees(np.angle(way))
    s.page.rates[CAM, "pressure"] = s.pen.rounded(float(angle))
    s.page.units[CAM, "pressure"] = "deg"


def _sine(u: float) -> tuple[float, float, float]:
    turn = 2 * np.pi * u
    return u - np.sin(turn) / (2 * np.pi), 1 - np.cos(turn), 2 * np.pi * np.sin(turn)


def _cosine(u: float) -> tuple[float, float, float]:
    turn = np.pi * u
    return (1 - np.cos(turn)) / 2, np.pi / 2 * np.sin(turn), np.pi**2 / 2 * np.cos(turn)


def _parabola(u: float) -> tuple[float, float, float]:
    if u <= 0.5:
        return 2 * u**2, 4 * u, 4.0
    return 1 - 2 * (1 - u) ** 2, 4 * (1 - u), -4.0


LAWS = {"sine": _sine, "cosine": _cosine, "constant acceleration": _parabola}
CAMMED = Machine(
    {"D.S": 0.0005, "D.dS": 0.0005, "D.ddS": 0.001},
    {"rise": 120.0, "dwell": 30.0, "fall": 90.0, "parts": 8, "stroke": 0.03, "r0": 0.07, "e": 0.01},
    (), cam, frozenset(), (), 18,
)  # fmt: skip
