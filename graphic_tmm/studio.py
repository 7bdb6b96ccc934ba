"""The whole road, a few verbs in a row: read, construct, choose scales, execute."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence, Set
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from graphic_tmm.board.hand import MOST, Hand
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.table import cam_columns, cam_positions
from graphic_tmm.chapters.diagrams.table import (
    chart_columns,
)
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.chapters.flywheel.table import (
    flywheel_columns,
    flywheel_results,
    rim_too_wide,
)
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.errors import Fault, SceneError, ViewError
from graphic_tmm.fitting import fitted, fitted_parts
from graphic_tmm.language.words import plain
from graphic_tmm.parts import Part, draws_mechanism
from graphic_tmm.readers.columns import Column, Positions, columns
from graphic_tmm.readers.findings import finding, left_out
from graphic_tmm.readers.spread import spread_columns, spread_results
from graphic_tmm.readers.text import result_tables, rich_tables
from graphic_tmm.readers.wheels import wheel_columns
from graphic_tmm.readers.writing import as_csv, as_json, decimals_of
from graphic_tmm.remedies import refusal, refuse_tiny
from graphic_tmm.scene.quantities import near
from graphic_tmm.scene.records import Scene
from graphic_tmm.work import Work, assumed, hand_of, ranges

if TYPE_CHECKING:
    from graphic_tmm.paper.drawing import Sheet

DEFAULT = "windrower"
"""The scene that is drawn when none is named."""


def sheets(scene: Scene) -> tuple[Made, tuple[Sheet, ...]]:
    """Draw a scene onto its sheets; further sheets follow if those ordered do not hold it."""
    from graphic_tmm.paper.compose import compose

    made = make(scene, wanted=scene.shown)
    try:
        return made, compose(scene, made.work, made.parts)
    except ViewError as error:
        raise refusal(scene, error) from error


def make(scene: Scene, *, exact: bool = False, wanted: Set[str] | None = None) -> Made:
    """Draw a scene: its mechanism, if it has one, and its parts.

    All that it calls for is drawn, or of that only what is ``wanted`` (places of a sheet); but whether the rest
    can be drawn is found out nevertheless.

    Raises
    ------
    SceneError
        If it has neither.
    SheetError
        If a scale factor that it fixes draws a plan too small to measure.
    """
    parts = fitted_parts(scene, exact=exact, wanted=wanted)
    if not draws_mechanism(scene, parts):
        return Made(scene, None, parts)
    drawn = fitted(scene, parts=parts, exact=exact, wanted=wanted)
    refuse_tiny(scene, drawn)
    return Made(scene, drawn, parts)


class Made(NamedTuple):
    """A scene as drawn: its mechanism, None if it has none, and its parts."""

    scene: Scene
    work: Work | None
    parts: tuple[Part, ...]

    @property
    def exact(self) -> bool:
        """Whether lengths are read without rounding."""
        hands = [part.hand for part in self.parts] + ([self.work.hand] if self.work else [])
        return all(hand.ruler is None for hand in hands)


SCALE_KEYS = {
    "positions": "mu_l",
    "velocities": "mu_v",
    "accelerations": "mu_a",
    "diagram S": "mu_diagram_S",
    "diagram V": "mu_diagram_V",
    "diagram a": "mu_diagram_a",
    "base": "mu_base",
    "lever": "mu_lever",
    "engine": "mu_F_engine",
    "harmonics": "mu_F_harmonics",
    "gear": "mu_l_gears",
    "sliding": "mu_theta",
    "planetary": "mu_l_planetary",
    "planetary-velocities": "mu_v_planetary",
    "planetary-rates": "mu_omega_planetary",
    **{f"engine {symbol}": f"mu_{symbol}_engine" for symbol in "PNQTKM"},
    "indicator": "mu_p",
    "moment": "mu_M",
    "work": "mu_A",
    "energy": "mu_T",
    "energy-mass": "mu_J",
}
"""What scale factors are called where machines read them."""
WIDTH = 220
"""Characters of a line of text where no terminal tells how many it has."""
FORMATS = ("svg", "pdf", "png", "dxf")
"""What sheets can be written as."""


def sheet_files(
    scene: Scene, formats: Sequence[str] = ("svg",)
) -> tuple[Made, dict[str, str | bytes]]:
    """Draw a scene; return its files by name: a file for each sheet, but one PDF for all of them."""
    from graphic_tmm.paper.write.dxf import dxf
    from graphic_tmm.paper.write.export import pdf, png
    from graphic_tmm.paper.write.svg import svg

    one: dict[str, Callable[[Sheet], str | bytes]] = {"svg": svg, "png": png, "dxf": dxf}
    made, drawn = sheets(scene)
    stem = scene_name(scene.source)
    names = [stem if len(drawn) == 1 else f"{stem}-{k + 1}" for k in range(len(drawn))]
    files: dict[str, str | bytes] = {}
    for form in formats:
        if form == "pdf":
            files[f"{stem}.pdf"] = pdf(drawn)
        else:
            for name, sheet in zip(names, drawn, strict=True):
                files[f"{name}.{form}"] = one[form](sheet)
    return made, files


def part_warnings(part: Part) -> tuple[str, ...]:
    """Return, for people, what of a part could not be drawn and why."""
    found = part.findings()
    told = [finding(f, part.names, "en") for f in found if f.kind == "undrawn"]
    told += left_out([f for f in found if f.kind == "lost"], part.names, "en")
    return (*told, *part.limits("en"))


def warnings(work: Work) -> tuple[str, ...]:
    """Return, for people, what could not be drawn, why, and over which range of the crank it could."""
    names, told = work.project.names, []
    if work.undrawn:
        missing = ", ".join(names[i] for i in work.undrawn)
        told.append(f"positions {missing} cannot be drawn" + ranges(work.project))
    findings = work.findings()
    told += [finding(f, names, "en") for f in findings if f.kind not in ("touching", "lost")]
    told += left_out([f for f in findings if f.kind == "lost"], names, "en")
    if wide := rim_too_wide(work.project, work.reading, "en"):
        told.append(f"flywheel: {plain(wide)}")
    return (*told, *assumed(work))


def packaged() -> list[Path]:
    """Return the folders of the scenes that come with the package, by name."""
    package = Path(__file__).parent
    homes = [package / "scenes", package.parent / "sheets"]
    found = {path.parent.name: path.parent for home in homes for path in home.glob("*/scene.toml")}
    return [found[name] for name in sorted(found)]


def scene_path(name: str | None) -> Path:
    """Return the folder or file of a scene: a path, or the name of a scene that comes with the package.

    Raises
    ------
    SceneError
        If there is neither.
    """
    wanted = DEFAULT if name is None else name
    if name is not None and Path(name).exists():
        return Path(name)
    found = {path.name: path for path in packaged()}
    if wanted in found:
        return found[wanted]
    from graphic_tmm.scene.read import SCENE

    meant = near(wanted, found, 0.8)
    said = f', did you mean the scene "{meant}"?' if meant else f"; {SCENE.remedy}"
    listed = '"graphic-tmm scenes" lists those that come with it'
    raise SceneError(wanted, (Fault("", 0, f"there is no such file{said}; {listed}"),))


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
    found += chart_columns(project, work.reading, work.accelerated)
    found += flywheel_columns(project, work.reading)
    found += force_columns(project, work.reading)
    found += engine_columns(project, work.reading)
    return [column.without(work.undrawn) for column in found]


def table(
    made: Made | Work, form: str, trials: int = 1, *, width: int = WIDTH, comma: bool = False
) -> str | list[Any]:
    """Return the tables of a scene as CSV or JSON text, or as rich tables for ``form`` "text".

    ``width``: the characters that a line of text has; ``comma``: CSV with decimal commas. ``trials``:
    how often the scene's hand draws everything; more than once, each figure is followed by the median and the
    5th and 95th hundredths of them.
    """
    if isinstance(made, Work):
        made = Made(made.scene, made, ())
    work, scene = made.work, made.scene
    found = scene_columns(made)
    positions = _positions(made)
    results, numbers = _structure(made), scene_results(made)
    if trials > 1:
        drawn = list(drawings(made, hand_of(made.scene, trials)))
        rows = [scene_columns(one) for one in drawn]
        found = spread_columns(found, rows)
        numbers = spread_results(numbers, [scene_results(one) for one in drawn])
    results |= {
        name: {"value": value, "unit": of}
        for name, (value, of) in numbers.items()
        if math.isfinite(value)
    }
    if form == "csv":
        return as_csv(positions, found, None if made.exact else _division(made), comma=comma)
    if form == "text":
        decimals = 3 if made.exact else decimals_of(_division(made))
        tables = rich_tables(found, positions, scene.language, scene.title, decimals, width)
        return [*tables, *result_tables(numbers, scene.language, scene.title)]
    scales = {k: s for k, s in work.scales.items()} if work is not None else {}
    scales |= {view: s for part in made.parts for view, s in part.scales().items()}
    told = {_scale_key(plan): {"value": s.value, "unit": s.unit} for plan, s in scales.items()}
    return as_json(scene_name(scene.source), told, positions, found, results)


def _positions(made: Made) -> Positions:
    """Return the positions of a scene: those of its mechanism, else of its cam; none of wheels alone."""
    if made.work is not None:
        return tuple(zip(made.work.project.names, made.work.project.angles, strict=True))
    cam = _cam(made)
    return cam_positions(cam) if cam is not None else ()


def _division(made: Made) -> float:
    """Return the division of the coarsest ruler that a scene is read with, mm."""
    hands = [part.hand for part in made.parts] + ([made.work.hand] if made.work else [])
    return max((hand.ruler for hand in hands if hand.ruler is not None), default=0.1)


def _part_results(made: Made) -> dict[str, tuple[float, str]]:
    return {name: found for part in made.parts for name, found in part.results().items()}


def _cam(made: Made) -> Part | None:
    return next((part for part in made.parts if isinstance(part.made, Cam)), None)


def scene_columns(made: Made) -> list[Column]:
    """Return the columns of a scene: of its mechanism and of its parts, which have positions of their own."""
    found = table_columns(made.work) if made.work is not None else []
    for part in made.parts:
        found += cam_columns(part) if isinstance(part.made, Cam) else wheel_columns(part)
    return found


def drawings(made: Made, hand: Hand) -> Iterator[Made]:
    """Yield the drawings that a hand makes, one a trial; so many as a block has are held at a time."""
    for first in range(0, hand.trials, MOST):
        some = hand._replace(first=hand.first + first, trials=min(MOST, hand.trials - first))
        work = made.work.drawn_by(some) if made.work is not None else None
        parts = [part.drawn_by(some) for part in made.parts]
        for k in range(some.trials):
            own = work.trial(k) if work is not None else None
            yield Made(made.scene, own, tuple(part.trial(k) for part in parts))


def _structure(made: Made) -> dict[str, Any]:
    if made.work is None:
        return {}
    structure = made.work.project.structure
    return {"W": structure.mobility, "formula": structure.formula}


def scene_results(made: Made) -> dict[str, tuple[float, str]]:
    """Return the results of a scene by name."""
    found = _part_results(made)
    if made.work is not None:
        project, reading = made.work.project, made.work.reading
        found = flywheel_results(project, reading) | engine_results(project, reading) | found
    return found


def _scale_key(plan: str) -> str:
    """Return what the scale factor of a view is called where machines read it; forces 4-5 -> mu_F_4_5."""
    if plan.startswith("forces "):
        return "mu_F_" + plan.removeprefix("forces ").replace("-", "_").replace(" ", "_pass_")
    return SCALE_KEYS.get(plan, "mu_" + plan.replace(" ", "_").replace("-", "_"))
