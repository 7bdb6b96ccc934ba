"""What the check says of drawings of a student of one's own: `python tests/benchmarks/own_student.py`.

Honest drawings in scale factors of the student's own, and drawings with one mistake each
(`support/own_student/kinds.txt`), written as people write them. `--honest 400 --wrong 624` are usual,
`--kind WORD` takes some kinds, `--show` prints every drawing that is not told rightly,
`--keep FOLDER` writes its table, `--no-mu-rows` leaves out rows of μ, `--scene-mu` draws in the task's μ.
"""

from __future__ import annotations

import argparse
import re
import sys
import time
from collections import Counter, defaultdict
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.own_student.machines import MACHINES
from support.own_student.mistakes import KINDS
from support.own_student.student import Drawing, due_factors, student
from support.own_student.table import WAYS
from support.own_told import NAMED, report_of, scales, told, with_mistake

from graphic_tmm.checking.records import DOUBTFUL, WRONG

Rows = dict[str, Counter[str]]


def honest(args: Any) -> None:
    """Print how honest drawings are judged."""
    rows: Rows = defaultdict(Counter)
    names, began = list(MACHINES), time.process_time()
    for i in range(args.honest):
        machine, way = MACHINES[names[i % len(names)]], WAYS[i // len(names) % len(WAYS)]
        mu = due_factors(machine) if args.scene_mu else None
        drawing = student(machine, args.first + i, way=way, mu=mu, mu_rows=args.mu_rows)
        row = rows[{"machine": machine.name, "move": drawing.manner.move}.get(args.by, way)]
        row["drawings"] += 1
        report = report_of(drawing)
        if isinstance(report, str):
            failed(args, drawing, row, report)
            continue
        wrong = [one for one in report.readings if one.verdict == WRONG]
        row["readings"] += len(report.readings)
        row["wrong readings"] += len(wrong)
        row["doubtful"] += sum(one.verdict == DOUBTFUL for one in report.readings)
        row["with a wrong one"] += bool(wrong)
        row["named"] += any(one.kind in NAMED for one in report.mistakes)
        scaled(args, drawing, row, report)
        if wrong:
            says = ", ".join(
                f"{one.taken.key} {one.found:.4g} for {one.due:.4g}" for one in wrong[:3]
            )
            keep(args, drawing, "honest", f"{len(wrong)} wrong: {says}")
    print(f"honest drawings, {time.process_time() - began:.0f} s of the processor")
    table(rows)


def mistaken(args: Any) -> None:
    """Print what is said of drawings with a mistake."""
    rows: Rows = defaultdict(Counter)
    kinds = [kind for kind in KINDS if re.search(args.kind, f"{kind.plan}: {kind.name}")]
    began = time.process_time()
    for i in range(min(args.wrong, 12 * len(kinds))):
        kind = kinds[i % len(kinds)]
        try:
            drawing = with_mistake(
                kind, i // len(kinds), args.first, own=not args.scene_mu, mu_rows=args.mu_rows
            )
        except ValueError as error:  # it moves too little in these scale factors
            print(error)
            continue
        row = rows[f"{kind.plan}: {kind.name}" if args.by == "kind" else kind.plan]
        row["drawings"] += 1
        report = report_of(drawing)
        if isinstance(report, str):
            failed(args, drawing, row, report)
            continue
        one = told(report, drawing)
        row += Counter(place=one.place, family=one.family, name=one.name, sure=one.sure)
        row["sure, wrong"] += one.sure and not one.name
        row["unknown"] += not one.named
        row["no reading wrong"] += not report.wrong
        scaled(args, drawing, row, report)
        rows[f"{kind.plan}: {kind.name}" if args.by == "kind" else kind.plan] = row
        if not one.name:
            keep(args, drawing, "sure" if one.sure else "name", one.says)
    print(f"drawings with a mistake, {time.process_time() - began:.0f} s of the processor")
    table(rows)


SWALLOWED = (
    "OA 1.25 times",
    "omega halved",
    "diameter for radius",
    "pa laid off 1.25 times",
    "omega not squared in πa",
)


def swallowed(args: Any) -> None:
    """Print what is told where an own μ might swallow a mistake: eight drawings a row in the task's μ."""
    print("drawn in the task's μ: what is told")
    rows: Rows = {}
    for kind in KINDS:
        if kind.name not in SWALLOWED and kind.family != "copy":
            continue
        for way in ("mm", "mm and rates"):
            row = rows.setdefault(f"{kind.name}, {way}", Counter())
            for turn in range(8):
                drawing = with_mistake(
                    kind, turn, args.first, own=False, mu_rows=False, ways=(way,)
                )
                row["drawings"] += 1
                report = report_of(drawing)
                if isinstance(report, str):
                    failed(args, drawing, row, report)
                    continue
                one = told(report, drawing)
                row["name right"] += one.name
                row["sure, wrong"] += one.sure and not one.name
                row["with wrong readings"] += report.wrong > 0
                for plan, what in scales(report, drawing):
                    row[f"own μ of {plan}"] += what == "false"
                if not one.name:
                    keep(args, drawing, "swallow", one.says)
    table(rows)


def scaled(args: Any, drawing: Drawing, row: Counter[str], report: Any) -> None:
    """Count what was told of the scale factors of a drawing."""
    for plan, what in scales(report, drawing):
        row[f"μ {what}"] += 1
        if what in ("false", "not told"):
            keep(args, drawing, f"μ {what}", f"{plan} {drawing.ratios[plan]:.4f} times the task's")


def failed(args: Any, drawing: Drawing, row: Counter[str], why: str) -> None:
    """Count a drawing that has no report."""
    what = why.partition(":")[0]
    row[what] += 1
    keep(args, drawing, what, why)


def table(rows: Rows) -> None:
    """Print counts, and their sum."""
    heads = list(dict.fromkeys(head for row in rows.values() for head in row))
    print("| | " + " | ".join(heads) + " |\n|---|" + "---:|" * len(heads))
    total: Counter[str] = sum(rows.values(), Counter())
    for name, row in [*rows.items(), ("**sum**", total)]:
        print(f"| {name} | " + " | ".join(str(row[head]) for head in heads) + " |", flush=True)


def keep(args: Any, drawing: Drawing, what: str, says: str) -> None:
    """Print a drawing that is not told rightly, and write its table."""
    truth, machine = drawing.truth, drawing.machine.name
    mistake = f"{truth.name} ({truth.position})" if truth else ""
    if args.show:
        manner = f"{drawing.manner.way}, {drawing.manner.move}"
        print(f"{what:9} {machine} {drawing.seed} [{manner}] {mistake}: {says[:500]}", flush=True)
    if args.keep:
        name = re.sub(r"\W+", "-", f"{what} {machine} {mistake} {drawing.seed}")
        (Path(args.keep) / f"{name}.csv").write_text(drawing.csv, encoding="utf-8")


def main() -> None:
    """Run what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--honest", type=int, default=400)
    parser.add_argument("--wrong", type=int, default=624)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--kind", default="", help="kinds whose plan and name have this pattern")
    parser.add_argument("--by", choices=["way", "machine", "move", "kind"], default="way")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--keep", default="")
    parser.add_argument("--no-mu-rows", dest="mu_rows", action="store_false")
    parser.add_argument("--scene-mu", action="store_true")
    parser.add_argument("--no-swallowed", dest="swallowed", action="store_false")
    args = parser.parse_args()
    if args.honest:
        honest(args)
    if args.wrong:
        mistaken(args)
    if args.swallowed:
        swallowed(args)


if __name__ == "__main__":
    main()
