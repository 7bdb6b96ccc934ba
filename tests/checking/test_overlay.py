"""The overlay: the exact plan thin, a cross where each point was read, on the smallest sheet."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import exact

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.pictures import overlay_sheet
from graphic_tmm.checking.records import FINE, WRONG, Judged, Report, Taken
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Sheet

AWAY = 3.0 + 4.0j


def read(name: str, *wanted: tuple[str, str], wrong: bool = False) -> Report:
    """Every point of some plans and positions, 5 mm away from its due."""
    rows = []
    for (plan, letter, position), z in points(exact(name)).items():
        if (plan, position) in wanted:
            found = z + AWAY
            taken = Taken(plan, position, letter, x=found.real, y=found.imag)
            verdict = WRONG if wrong else FINE
            rows.append(Judged(taken, abs(found), abs(z), 5.0, 5.0, 0.5, verdict, "mm", "", None))
    return Report(name, "", "en", "student", tuple(rows), ())


def crosses(sheet: Sheet) -> list[complex]:
    """Where the crosses stand on the sheet: two strokes of one middle."""
    middles = []
    for view in sheet.drawings:
        for stroke in view.strokes:
            if stroke.title.endswith(": 5.00 mm") and len(stroke.path) == 2:
                (a, b, _), (c, d, _) = stroke.path
                middles.append(complex(a + c, b + d) / 2)
    return [z for k, z in enumerate(middles) if any(abs(z - w) < 1e-9 for w in middles[:k])]


@pytest.mark.parametrize("enlarge", [1.0, 2.0])
@pytest.mark.parametrize("plan", ["positions", "velocities", "accelerations"])
def test_a_cross_stands_where_a_point_was_read(plan: str, enlarge: float) -> None:
    report = read("engine", (plan, "2"))
    sheet = overlay_sheet(exact("engine"), report, enlarge)
    due = {k: z for k, z in points(exact("engine")).items() if (k[0], k[2]) == (plan, "2")}
    found = crosses(sheet)
    assert len(found) == len(due) == len(report.readings)
    ways = {
        round((a - z).real, 6) + 1j * round((a - z).imag, 6)
        for a, z in zip(found, due.values(), strict=True)
    }
    assert (
        len(ways) == 1
    )  # all are moved alike: by the place of the plan on the sheet, and by the deviation
    told = [
        s.path for view in sheet.drawings for s in view.strokes if s.title.endswith(": 5.00 mm")
    ]
    shafts = [abs(complex(b[0] - a[0], b[1] - a[1])) for a, b, *_ in told]
    assert max(shafts) == pytest.approx(abs(AWAY) * enlarge)


def test_the_exact_plan_is_thin_and_what_is_wrong_is_heavy() -> None:
    for wrong in (False, True):
        sheet = overlay_sheet(
            exact("engine"), read("engine", ("velocities", "3"), wrong=wrong), 1.0
        )
        (plan,) = (v for v in sheet.drawings if v.name.startswith("overlay"))
        told = [s for s in plan.strokes if s.title.endswith(": 5.00 mm")]
        assert {s.pen for s in told} == {"main" if wrong else "medium"}
        assert {s.pen for s in plan.strokes if s not in told} == {"thin"}
        drawn = {s.title.split(" = ")[0] for s in plan.strokes}
        assert {"pa", "ab", "pb"} <= drawn


def test_the_sheet_is_the_smallest_that_holds_the_plans() -> None:
    assert overlay_sheet(exact("engine"), read("engine", ("velocities", "3")), 1.0).format == "A4"
    many = [(plan, str(n)) for plan in ("positions", "velocities") for n in range(1, 9)]
    assert overlay_sheet(exact("engine"), read("engine", *many), 1.0).format == "A1"


def test_no_points_are_told() -> None:
    with pytest.raises(SheetError, match="no points were read"):
        overlay_sheet(exact("engine"), Report("engine", "", "en", "student", (), ()), 1.0)


def test_the_overlay_shows_what_was_read(tmp_path: Path) -> None:
    spots = points(exact("engine"))
    lines = ["plan,position,segment,x,y"]
    for (plan, letter, position), z in spots.items():
        if plan == "velocities" and position in ("2", "3"):
            lines.append(f"{plan},{position},{letter},{z.real + 1.0},{z.imag}")
    path, out = tmp_path / "r.csv", tmp_path / "o.svg"
    path.write_text("\n".join(lines) + "\n", "utf-8")
    arguments = [
        "check",
        "engine",
        str(path),
        "--overlay",
        str(out),
        "--enlarge",
        "5",
        "--trials",
        "40",
    ]
    done = invoke(*arguments)
    assert done.exit_code in (0, 1), done.output
    assert out.read_text("utf-8").startswith("<?xml") or "<svg" in out.read_text("utf-8")
