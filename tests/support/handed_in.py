"""A class that hands in: each student draws his own variant of a slider-crank with numpy, some mistake it.

The students are those of `support.students`: they know the mechanism by its dimensions in mm on the sheet and
its μ, not by its scene.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from support.another_hand import Rows
from support.gallery import CASES
from support.students.drawing import Student
from support.students.machines import MACHINES
from support.students.records import Hand, Machine, Mind, Operands, Step, V
from support.students.writing import csv_of, rows_of

SCENE = "slider.toml"
HONEST, MISTAKEN = "honest", "mistaken"


class HandIn(NamedTuple):
    """What a student hands in: which variant, whether his drawing is honest, his readings."""

    variant: str
    kind: str
    rows: Rows

    @property
    def text(self) -> str:
        """The file of readings."""
        return csv_of(self.rows)


def values(number: int) -> tuple[int, int]:
    """Return what a variant gives: OA and AB, mm."""
    return 80 + 2 * (number % 16), 330 + 5 * (number % 9)


def scene_text(positions: int = 20) -> str:
    """Return the scene that the class draws variants of: its lengths named, so many positions."""
    text = (CASES / "check" / "sc.toml").read_text("utf-8")
    text = (
        text.replace('"100 mm"', '"OA"').replace('"350 mm"', '"AB"').replace('"140 mm"', '"0.4 AB"')
    )
    text = text.replace("positions = 8", f"positions = {positions}")
    return text.replace("[frame]", '[lengths]\nOA = "100 mm"\nAB = "350 mm"\n[frame]')


def variant_text(number: int, positions: int = 20) -> str:
    """Return the scene of a variant, as a teacher would write it."""
    crank, rod = values(number)
    text = scene_text(positions).replace('OA = "100 mm"', f'OA = "{crank} mm"')
    text = text.replace('AB = "350 mm"', f'AB = "{rod} mm"')
    return text.replace('"Slider-crank"', f'"Slider-crank. Variant {number:02d}"')


def table_text(count: int) -> str:
    """Return the table of variants: 01, 02 …"""
    rows = (f"{k:02d},{values(k)[0]},{values(k)[1]}" for k in range(1, count + 1))
    return "\n".join(['variant,"OA, mm","AB, mm"', *rows]) + "\n"


def machine(number: int, positions: int = 20) -> Machine:
    """Return a variant's mechanism as a student has it on paper: μ_l is 2 mm/mm."""
    crank, rod = values(number)
    given = {"OA": crank / 2, "AB": rod / 2, "AS2": 0.4 * rod / 2, "omega": 20.0}
    return MACHINES["sc"]._replace(given=given, positions=positions)


def wrong_link(step: Step) -> Operands:
    """Take the crank's length for the rod's wherever ω is calculated."""
    return {**step.takes, "link": "OA"} if (step.kind, step.plan) == ("rate", V) else step.takes


def wrong_sense(step: Step) -> Operands:
    """Lay the normal component off the other way."""
    return {**step.takes, "sense": -1.0} if step.name == "an2" else step.takes


def wrong_way(step: Step) -> Operands:
    """Draw the relative velocity 20° off the square to the rod."""
    return {**step.takes, "off": 20.0} if (step.kind, step.name) == ("ray", "ab") else step.takes


MINDS: tuple[Mind, ...] = (wrong_link, wrong_sense, wrong_way)


def hand_in(
    number: int, seed: int, *, mind: Mind | None = None, positions: int = 20, mode: str = "both",
    hand: Hand = Hand(),  # noqa: B008
) -> HandIn:  # fmt: skip
    """Draw a variant, with a mistake or without, and read it."""
    of = machine(number, positions)
    drawn = Student(of, hand, seed, mind).draw() if mind else Student(of, hand, seed).draw()
    return HandIn(f"{number:02d}", MISTAKEN if mind else HONEST, rows_of(drawn, mode))


def hand_ins(count: int, *, positions: int = 20, mode: str = "both") -> Iterator[HandIn]:
    """Yield the hand-ins of a class, every third with a mistake."""
    for k in range(1, count + 1):
        mind = MINDS[k // 3 % len(MINDS)] if k % 3 == 0 else None
        yield hand_in(k, 7000 + k, mind=mind, positions=positions, mode=mode)


def write_class(folder: Path, count: int, *, positions: int = 20, mode: str = "both") -> Path:
    """Write scene, table and hand-ins of a class below a folder; return the folder of the hand-ins."""
    (folder / SCENE).write_text(scene_text(positions), "utf-8")
    (folder / "variants.csv").write_text(table_text(count), "utf-8")
    place = folder / "handed"
    place.mkdir()
    for one in hand_ins(count, positions=positions, mode=mode):
        (place / f"{one.variant}.csv").write_text(one.text, "utf-8")
    return place
