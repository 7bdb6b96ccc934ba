"""The whole road, a few verbs in a row: read, construct, choose scales, execute."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import Finding, examine
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard, standard_length
from graphic_tmm.board.values import Curve, Point, undefined
from graphic_tmm.errors import Fault, SceneError, StructureError
from graphic_tmm.mechanism.synthesis import Found, rocker
from graphic_tmm.plans.project import Project, draw_project
from graphic_tmm.scene.records import Scales, Scene
from graphic_tmm.tables import Column, as_csv, as_json, columns, rich_tables
from graphic_tmm.words import CAPTIONS, finding
from graphic_tmm.words import protocol as narrate

if TYPE_CHECKING:
    from graphic_tmm.paper.compose import Drawn
    from graphic_tmm.paper.drawing import Sheet

DEFAULT = "windrower"
"""The scene that is drawn when none is named."""
ROOM = {"A1": 230.0, "A4": 130.0}
"""For a format: room for the plan of positions, mm."""
VECTORS = (150.0, 125.0, 100.0, 80.0, 65.0, 50.0)
"""Room for the longest vector of a plan, mm: as much as the sheets hold."""


@dataclass(frozen=True)
class Work:
    """A scene that has been drawn: its log, its numbers, its scale factors, what went wrong."""

    scene: Scene
    project: Project
    given: Mapping[Mark, object]
    scales: Mapping[str, Scale]
    reading: Reading
    accelerated: Reading | None
    hand: Hand
    undrawn: tuple[int, ...]

    def drawn(self, *, lettered: bool = True) -> Drawn:
        """Return what is inked; unlettered, the plans only take their room."""
        from graphic_tmm.paper.compose import Drawn

        return Drawn(
            self.scene,
            self.project,
            self.reading,
            self.accelerated,
            self.scales,
            self.undrawn,
            lettered,
        )

    def findings(self) -> tuple[Finding, ...]:
        """Return what could not be drawn, or was drawn at the edge of its possibility."""
        log = self.project.construction
        plain = [s.it for s in log.steps if s.it.view != "accelerations" and not s.op.across]
        found = examine(log, self.given, plain, hand=self.hand)
        if self.project.accelerations is None:
            return found
        marks = self.project.marks("accelerations")
        more = examine(log, self.given, marks, hand=self.hand, positions=self.project.accelerated)
        return (*found, *(f for f in more if f.step.it.view == "accelerations"))


def work(scene: Scene, *, exact: bool = False, vectors: tuple[float, float] = (80.0, 80.0)) -> Work:
    """Draw a scene: record its plans, choose the scale factors, execute.

    ``exact`` switches the rounding of the ruler off; ``vectors`` is the room, mm, for the
    longest vector of the plans of velocities and of accelerations.
    """
    wanted = {plan for sheet in scene.sheets for plan in sheet.place}
    plans = [p for p in ("positions", "velocities", "accelerations") if p in wanted]
    project = draw_project(
        scene.mechanism,
        scene.row,
        turned=scene.turned,
        trajectories=scene.trajectories,
        plans=plans,
    )
    formats = [sheet.format for sheet in scene.sheets]
    scales = choose_scales(project, scene.scales, ROOM["A1" if "A1" in formats else "A4"], vectors)
    given = dict(project.given)
    for plan, scale in scales.items():
        given[project.scale(plan)] = scale.value
    hand = EXACT if exact else Hand(scene.ruler)
    log = project.construction
    still = [m for m in (*log.given, *(s.it for s in log.steps)) if m.view != "accelerations"]
    reading = execute(log, given, still, hand=hand)
    accelerated = None
    if project.accelerations is not None:
        steps = [step for step in log.steps if step.it.view == "accelerations"]
        whole = {mark for step in steps for mark in (step.it, *step.uses)}
        accelerated = execute(log, given, whole, hand=hand, positions=project.accelerated)
    undrawn = _undrawn(project, reading)
    if len(undrawn) == len(project.names):
        raise StructureError("none of the positions can be drawn" + _ranges(project))
    return Work(scene, project, given, scales, reading, accelerated, hand, undrawn)


def sheets(scene: Scene) -> tuple[Work, tuple[Sheet, ...]]:
    """Draw a scene onto its sheets; further sheets follow if those ordered do not hold it."""
    from graphic_tmm.paper.compose import compose

    made = fitted(scene)
    return made, compose(made.drawn())


def sheet_texts(scene: Scene) -> tuple[Work, dict[str, str]]:
    """Draw a scene; return the SVG texts of its sheets by file name."""
    from graphic_tmm.paper.svg import svg

    made, drawn = sheets(scene)
    stem = scene_name(scene.source)
    names = [stem if len(drawn) == 1 else f"{stem}-{k + 1}" for k in range(len(drawn))]
    return made, {f"{name}.svg": svg(sheet) for name, sheet in zip(names, drawn, strict=True)}


def fitted(scene: Scene, *, exact: bool = False) -> Work:
    """Draw a scene with its plans as large as fit on the sheets ordered.

    Every reader of a scene takes this μ, so that a table speaks of the sheet that is drawn.
    """
    from graphic_tmm.paper.compose import compose

    tried: dict[tuple[float, ...], bool] = {}

    def fits(rooms: tuple[float, float]) -> bool:
        made = work(scene, vectors=rooms)
        factors = tuple(scale.value for scale in made.scales.values())
        if factors not in tried:
            tried[factors] = len(compose(made.drawn(lettered=False))) <= len(scene.sheets)
        return tried[factors]

    rooms = next(((r, r) for r in VECTORS if fits((r, r))), (VECTORS[-1], VECTORS[-1]))
    for larger in reversed([r for r in VECTORS if r > rooms[1]]):
        rooms = (rooms[0], larger) if fits((rooms[0], larger)) else rooms
    return work(scene, exact=exact, vectors=rooms)


def warnings(work: Work) -> tuple[str, ...]:
    """Return, for people, what could not be drawn, why, and over which range of the crank it could."""
    names, told = work.project.names, []
    if work.undrawn:
        missing = ", ".join(names[i] for i in work.undrawn)
        told.append(f"positions {missing} cannot be drawn" + _ranges(work.project))
    for found in work.findings():
        if found.kind != "touching":
            told.append(finding(found, names, "en"))
    return tuple(told)


def _ranges(project: Project) -> str:
    ranges = " and ".join(f"{a % 360:.2f}° to {b % 360:.2f}°" for a, b in project.assembly.ranges)
    groups = ", ".join(project.assembly.groups)
    return f": group {groups} assembles for crank angles {ranges} only" if ranges else ""


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks("positions"):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))


def choose_scales(
    project: Project, wanted: Scales, room: float, vectors: tuple[float, float]
) -> dict[str, Scale]:
    """Return μ of every plan drawn: what the scene fixes, else a standard one, found with the exact hand.

    A segment fixed in mm (OA, pa, πa) gives its μ; the choice makes the plan of positions and the longest
    vectors as large as ``room`` and ``vectors`` (mm) allow.
    """
    log, given = project.construction, dict(project.given)
    for view in log.views:
        assert view.scale is not None
        given[view.scale] = 1.0
    arm, pin_speed, pin_acceleration = _crank(project)
    points = [m for m in project.marks("positions") if m.kind is Point]
    reading = execute(log, given, points)
    extent = _extent([reading[mark] for mark in points])
    mu_l = wanted.mu_l or (arm / wanted.OA if wanted.OA else standard_length(extent, room))
    scales = {"positions": Scale("μ_l", mu_l, "m/mm")}
    if project.velocities is not None:
        longest = _longest(project, given, "velocities", None)
        mu_v = wanted.mu_v or (
            pin_speed / wanted.pa if wanted.pa else standard(longest, vectors[0])
        )
        if wanted.mu_v_is_mu_l_omega:
            mu_v = mu_l * abs(project.mechanism.drive.speed)
        scales["velocities"] = Scale("μ_v", mu_v, "(m/s)/mm")
    if project.accelerations is not None:
        longest = _longest(project, given, "accelerations", project.accelerated)
        mu_a = wanted.mu_a or (
            pin_acceleration / wanted.pi_a if wanted.pi_a else standard(longest, vectors[1])
        )
        scales["accelerations"] = Scale("μ_a", mu_a, "(m/s²)/mm")
    return scales


def _crank(project: Project) -> tuple[float, float, float]:
    drive, structure = project.mechanism.drive, project.structure
    crank = project.mechanism.by_number[structure.driver]
    arm = abs(crank.points[structure.pin] - crank.points[structure.pivot])
    return arm, abs(drive.speed) * arm, abs(drive.speed**2 + 1j * drive.acceleration) * arm


def _extent(points: list[np.ndarray]) -> float:
    flat = np.concatenate([np.ravel(p) for p in points])
    flat = flat[np.isfinite(flat)]
    width, height = np.ptp(flat.real), np.ptp(flat.imag)
    return float(max(width, height))


def _longest(
    project: Project, given: Mapping[Mark, object], plan: str, at: tuple[int, ...] | None
) -> float:
    points = [m for m in project.marks(plan) if m.kind is Point]
    reading = execute(project.construction, given, points, positions=at)
    lengths = [np.abs(reading[m]) for m in points]
    return max((float(np.nanmax(x)) for x in lengths if np.isfinite(x).any()), default=0.0)


def packaged() -> list[Path]:
    """Return the folders of the scenes that come with the package, by name."""
    package = Path(__file__).parent
    homes = [package / "scenes", package.parent / "sheets"]
    found = {path.parent.name: path.parent for home in homes for path in home.glob("*/scene.toml")}
    return [found[name] for name in sorted(found)]


def scene_path(name: str | None) -> Path:
    """Return the folder or file of a scene: a path, or the name of a scene that comes with the package."""
    wanted = DEFAULT if name is None else name
    if name is not None and Path(name).exists():
        return Path(name)
    return next((path for path in packaged() if path.name == wanted), Path(wanted))


def scene_name(source: str) -> str:
    """Return the name that a scene's sheets bear: that of its folder, or of its file."""
    path = Path(source).resolve()
    return path.parent.name if path.name == "scene.toml" else path.stem


def table_columns(work: Work) -> list[Column]:
    """Return the columns of all plans of a scene; null where a position cannot be drawn."""
    project, count = work.project, len(work.project.names)
    log, everywhere = project.construction, list(range(count))
    found = list(columns(log, work.reading, "positions", everywhere, count))
    if project.velocities is not None:
        rates = project.velocities.rates
        found += columns(log, work.reading, "velocities", everywhere, count, rates)
    if project.accelerations is not None and work.accelerated is not None:
        rates, places = project.accelerations.rates, list(project.accelerated)
        found += columns(log, work.accelerated, "accelerations", places, count, rates)
    return [column.without(work.undrawn) for column in found]


def table(work: Work, form: str) -> str | list[Any]:
    """Return the tables of a scene as CSV or JSON text, or as rich tables for ``form`` "text"."""
    project = work.project
    positions = list(zip(project.names, project.angles, strict=True))
    found = table_columns(work)
    if form == "csv":
        return as_csv(positions, found)
    if form == "text":
        decimals = 1 if work.hand.ruler is not None else 3
        return rich_tables(found, project.names, work.scene.language, work.scene.title, decimals)
    keys = {"positions": "mu_l", "velocities": "mu_v", "accelerations": "mu_a"}
    scales = {
        keys[plan]: {"value": scale.value, "unit": scale.unit}
        for plan, scale in work.scales.items()
    }
    results = {"W": project.structure.mobility, "formula": project.structure.formula}
    return as_json(scene_name(work.scene.source), scales, positions, found, results)


def protocol(
    work: Work, plans: Sequence[str], position: str | None, language: str
) -> Iterator[str]:
    """Yield the lines of the protocol of plans in one position.

    Raises
    ------
    SceneError
        If there is no such position, or it has no plan of accelerations.
    """
    project = work.project
    place = _position(work, position, needs="accelerations" if len(plans) == 1 else "")
    for plan in plans:
        yield from _plan_lines(work, plan, place, language)
        if plan == "accelerations" and len(plans) == 1 and place not in project.accelerated:
            raise _refused(work, plan, project.names[place])


def _plan_lines(work: Work, plan: str, place: int, language: str) -> Iterator[str]:
    project, log, reading, index = work.project, work.project.construction, work.reading, place
    if plan == "synthesis":
        found = synthesis(work.scene)
        if found is None:
            return
        log, reading, index = found.construction, execute(found.construction, found.given), 0
    if plan == "accelerations":
        if work.accelerated is None or place not in project.accelerated:
            return
        reading, index = work.accelerated, project.accelerated.index(place)
    lines = list(narrate(log, plan, reading, index, language))
    if not lines:
        return
    words = CAPTIONS[language]
    at = f", {words['position']} {project.names[place]}" if plan != "synthesis" else ""
    yield f"{words[plan]}{at}"
    for line in lines:
        yield f"{line.number:4}. {line.text}" if line.number else f"      [{line.text}]"
        if line.calculation:
            yield f"      {line.calculation}"
    yield ""


def _position(work: Work, name: str | None, needs: str) -> int:
    project = work.project
    if name is None:
        return next(iter(project.accelerated), min(1, len(project.names) - 1))
    if name not in project.names:
        raise SceneError(
            work.scene.source,
            (Fault("--position", 0, f"there is no {name}; there are {', '.join(project.names)}"),),
        )
    return project.names.index(name)


def _refused(work: Work, plan: str, name: str) -> SceneError:
    drawn = ", ".join(work.project.names[k] for k in work.project.accelerated) or "none"
    text = (
        f"position {name} has no plan of accelerations (those that have one: {drawn}); add it there"
    )
    return SceneError(work.scene.source, (Fault("drive.accelerations", 0, text),))


def synthesis(scene: Scene) -> Found | None:
    """Return the recorded synthesis of a scene that states a task."""
    return rocker(**scene.task.given) if scene.task is not None else None
