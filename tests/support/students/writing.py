"""What a student writes down of a drawing: rows of readings in mm, as quantities, as points, or both."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from support.another_hand import HEAD, Rows
from support.students.drawing import Student
from support.students.graphs import CAMMED, CHARTED
from support.students.loads import FORCED
from support.students.machines import MACHINES
from support.students.records import CAM, POLES, A, D, V

ALL = {**MACHINES, "fsc": FORCED, "dsc": CHARTED, "fol": CAMMED}
UNIT = {"positions": "m", V: "m/s", A: "m/s^2", "forces": "N"}
UNIT_OF = {(D, "S"): "m", (D, "V"): "m/s", (D, "a"): "m/s^2"}


def scale_of(student: Student, plan: str, name: str) -> float:
    """Return μ of a segment, SI per mm."""
    return student.mu[f"D.{name}"] if plan in (D, CAM) else student.mu[plan]


def unit_of(plan: str, name: str) -> str:
    return "m" if plan == CAM else UNIT_OF.get((plan, name)) or UNIT[plan]


def rows_of(student: Student, mode: str, mu: Mapping[str, float] | None = None) -> Rows:
    """Return the readings of a drawing; ``mu``: other scales with which quantities are calculated."""
    rows: Rows = {}
    calculated, scales = student.machine.calculated, mu or {}
    for k, page in enumerate(student.pages):
        for (plan, name), length in page.lengths.items():
            if not np.isfinite(length):
                continue
            mm = round(length, 1) if name in calculated else length
            by = scales.get(plan, scale_of(student, plan, name))
            value = f"{mm * by:.4g}" if mode in ("quantities", "both") else ""
            written = "" if mode == "quantities" else f"{mm:g}"
            rows[plan, str(k), name] = [
                written,
                value,
                unit_of(plan, name) if value else "",
                "",
                "",
            ]
        for (plan, name), number in page.rates.items():
            unit = page.units.get((plan, name)) or ("1/s" if plan == V else "1/s^2")
            if np.isfinite(number):
                rows[plan, str(k), name] = ["", f"{number:.4g}", unit, "", ""]
        if mode == "points":
            _spots(student, rows, k)
    return rows


def _spots(student: Student, rows: Rows, k: int) -> None:
    """Add the points, each from the pole that the student takes for it."""
    student.k = k
    for (plan, letter), z in student.pages[k].points.items():
        pole = 0j if plan not in POLES else student.hand.pole
        if np.isfinite(z):
            x, y = student.spot(f"{plan} {letter}", z, pole)
            rows[plan, str(k), letter] = ["", "", "", f"{x:g}", f"{y:g}"]


def csv_of(rows: Rows) -> str:
    """Return a file of readings."""
    return "\n".join([HEAD, *(",".join([*key, *cells]) for key, cells in rows.items())]) + "\n"
