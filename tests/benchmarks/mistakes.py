"""What the check says of an independent student's mistakes: `python tests/benchmarks/mistakes.py`.

Mistakes that are planted by tests/support/students (what counts as right is said in its measuring.py), two at
once, some outside any grammar, and honest drawings. ``--failures FILE`` writes what was not right, with seeds.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS), str(TESTS.parent)]

from support.another_hand import MODES  # noqa: E402
from support.students.drawings import HANDS, MACHINES, honest, pairs, planted  # noqa: E402
from support.students.early import EARLY  # noqa: E402
from support.students.kinds import Kind  # noqa: E402
from support.students.late import LATE  # noqa: E402
from support.students.later import LATER  # noqa: E402
from support.students.measuring import Outcome, outcomes  # noqa: E402
from support.students.outside import OUTSIDE  # noqa: E402
from support.students.planting import Planted  # noqa: E402

from graphic_tmm.checking.records import DOUBTFUL, WRONG  # noqa: E402

PARTS = {"early": EARLY, "late": LATE, "later": LATER}
INSIDE: tuple[Kind, ...] = tuple(kind for part in PARTS.values() for kind in part)
Rows = list[tuple[str, list[Outcome]]]


def share(part: int, whole: int) -> str:
    return f"{100.0 * part / whole:.0f} %" if whole else "–"


def table(title: str, rows: Rows) -> None:
    """Print the figures of drawings with one mistake, row by row."""
    print(f"\n| {title} | drawings | shown | place | family | member | sure: wrong | sure: right |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for name, found in rows:
        shown = [one for one in found if one.planted.truths[0].shown]
        figures = (
            sum(one.place for one in shown), sum(one.family for one in shown),
            sum(one.member for one in shown), sum(one.wrong > 0 for one in shown),
        )  # fmt: skip
        right, wrong = sum(one.right for one in shown), sum(one.wrong for one in shown)
        cells = [share(figure, len(shown)) for figure in figures] + [share(right, right + wrong)]
        print(f"| {name} | {len(found)} | {len(shown)} | {' | '.join(cells)} |")


def by(key: Callable[[Outcome], str], found: Iterable[Outcome]) -> Rows:
    """Group outcomes by a name, the worst first."""
    groups: dict[str, list[Outcome]] = {}
    for one in found:
        groups.setdefault(key(one), []).append(one)
    return sorted(
        groups.items(),
        key=lambda row: sum(one.family and one.place for one in row[1]) / len(row[1]),
    )


def part_of(one: Outcome) -> str:
    kind = one.planted.truths[0].kind
    return next(part for part, kinds in PARTS.items() if any(kind == each.name for each in kinds))


def readings_moved(one: Outcome) -> str:
    moved = one.planted.truths[0].moved
    return next((f"up to {most}" for most in (0, 1, 3, 10) if moved <= most), "more")


def told(one: Outcome) -> str:
    """Return what a report said, in a line."""
    return "; ".join(
        f"{each.kind} {each.family} {each.plan}/{each.segment or each.step}/{each.position} "
        f"{each.chance:.2f} «{each.name}: {each.says}»"
        + (f" or {len(each.like)} more" if each.like else "")
        for each in one.report.mistakes[:3]
    )


def write_failures(path: Path | None, found: Iterable[Outcome]) -> None:
    """Write what was not right so far: enough to draw it again."""
    if path is None:
        return
    with path.open("w", encoding="utf-8") as file:
        for one in found:
            of = one.planted
            for truth in of.truths:
                places = " ".join(sorted("/".join(place) for place in truth.places))
                file.write(
                    f"{of.machine} {of.mode} ruler {of.ruler:g} seed {of.seed}: {truth.kind} "
                    f"{list(truth.families)} at {places} position {truth.position or 'all'} {truth.words}"
                    f" {truth.moved} readings show it\n"
                )
            marks = [name for name in ("place", "family", "member") if getattr(one, name)]
            verdicts = [row.verdict for row in one.report.readings]
            file.write(
                f"    {verdicts.count(WRONG)} wrong, {verdicts.count(DOUBTFUL)} doubtful; right: "
                f"{', '.join(marks) or 'nothing'}; sure and wrong: {one.wrong}\n"
            )
            file.write(f"    told: {told(one) or 'nothing'}\n")


def measured(
    title: str, drawings: Iterable[Planted], kinds: Sequence[Kind], folder: Path
) -> list[Outcome]:
    """Check drawings; tell how long it took."""
    whole, start = list(drawings), time.perf_counter()
    found = list(outcomes(whole, folder, kinds))
    seconds = time.perf_counter() - start
    print(
        f"\n{title}: {len(found)} drawings, {seconds:.0f} s, {seconds / max(len(found), 1):.2f} s each",
        flush=True,
    )
    return found


def two_at_once(found: list[Outcome]) -> None:
    """Print how many of two mistakes are found: right first, both among those told."""
    first = sum(one.place and one.family for one in found)
    step = sum(one.place for one in found)
    both = sum(one.both for one in found)
    wrong = sum(one.wrong > 0 for one in found)
    print(
        f"two at once: right first {share(first, len(found))}, its place {share(step, len(found))}, "
        f"both {share(both, len(found))}, a sure name wrong {share(wrong, len(found))} of {len(found)}"
    )


def honest_table(
    wanted: int, seed: int, folder: Path, machines: Sequence[str], modes: Sequence[str]
) -> None:
    """Print how many honest drawings are told to have a mistake."""
    print(
        "\n| honest | drawings | a mistake told | at 80 % | a wrong reading |\n|---|---:|---:|---:|---:|"
    )
    for k, hand in enumerate(HANDS):
        drawings = honest(hand, wanted, seed + 1000 * k, machines, modes)
        found = list(outcomes(list(drawings), folder))
        named, sure = sum(one.named for one in found), sum(one.wrong > 0 for one in found)
        broken = sum(one.report.wrong > 0 for one in found)
        print(f"| {hand} | {len(found)} | {named} | {sure} | {broken} |", flush=True)


def chosen(kinds: Sequence[Kind], only: str | None) -> list[Kind]:
    return [kind for kind in kinds if not only or only in kind.name or only in kind.families]


def main() -> None:
    """Print the tables."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--planted", type=int, default=600, help="drawings with one mistake")
    asked.add_argument("--two", type=int, default=100, help="drawings with two")
    asked.add_argument("--outside", type=int, default=120, help="drawings outside the grammar")
    asked.add_argument("--honest", type=int, default=70, help="honest drawings of each hand")
    asked.add_argument("--share", type=float, default=1.0, help="of all these")
    asked.add_argument("--part", choices=PARTS, help="kinds of this part only")
    asked.add_argument("--only", help="kinds whose name has it, or of this family")
    asked.add_argument("--seed", type=int, default=20_000)
    asked.add_argument("--failures", type=Path, help="where to write what was not right")
    asked.add_argument("--machines", default=",".join(MACHINES), help="with commas")
    asked.add_argument(
        "--modes", default=",".join(MODES), help="how drawings are read, with commas"
    )
    given = asked.parse_args()
    where = given.machines.split(","), given.modes.split(",")
    failed: list[Outcome] = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if kinds := chosen(PARTS.get(given.part, INSIDE), given.only):
            wanted = int(given.planted * given.share)
            found = measured(
                "one mistake", planted(kinds, wanted, given.seed, *where), INSIDE, folder
            )
            table("all", [("all", found)])
            table("part", by(part_of, found))
            table("family", by(lambda one: one.planted.truths[0].families[0], found))
            table("scene", by(lambda one: one.planted.machine, found))
            table(
                "reach",
                by(lambda one: "one position" if one.planted.truths[0].position else "all", found),
            )
            table("readings that show it", by(readings_moved, found))
            table("read as", by(lambda one: one.planted.mode, found))
            table("kind", by(lambda one: one.planted.truths[0].kind, found))
            failed += [
                one for one in found if one.wrong or not (one.place and one.family and one.member)
            ]
            write_failures(given.failures, failed)
        if kinds := chosen(OUTSIDE, given.only):
            wanted = int(given.outside * given.share)
            found = measured("outside", planted(kinds, wanted, given.seed + 7, *where), (), folder)
            table("outside", [("all", found), *by(lambda one: one.planted.truths[0].kind, found)])
            failed += [one for one in found if one.wrong]
            write_failures(given.failures, failed)
        if not given.only:
            wanted = int(given.two * given.share)
            found = measured(
                "two at once", pairs(INSIDE, wanted, given.seed + 13, *where), INSIDE, folder
            )
            two_at_once(found)
            failed += [one for one in found if not one.both]
            write_failures(given.failures, failed)
            honest_table(int(given.honest * given.share), given.seed + 50_000, folder, *where)


if __name__ == "__main__":
    main()
