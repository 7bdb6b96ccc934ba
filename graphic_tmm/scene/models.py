"""The shape of a scene file, section by section, and the JSON Schema that editors read."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag
from pydantic.fields import FieldInfo

from graphic_tmm.scene import values as v
from graphic_tmm.scene.cam_tables import CamTable
from graphic_tmm.scene.force_tables import (
    EffectsTable,
    EngineTable,
    ForcesTable,
    FrictionTable,
    LoadTable,
)
from graphic_tmm.scene.order_tables import (
    DiagramsTable,
    FlywheelTable,
    IndicatorTable,
    StrokeTable,
    TracedTable,
)
from graphic_tmm.scene.table import Table, key
from graphic_tmm.scene.wheel_tables import GearsTable, PlanetaryTable


def _place(value: object) -> str:
    return "guide*" if isinstance(value, dict) else "point*"


def _slides(value: object) -> str:
    return "several*" if isinstance(value, list) else "one*"


def _zero(value: object) -> str:
    return "extreme*" if isinstance(value, dict) else "angle*"


TAGS = frozenset({"guide*", "point*", "several*", "one*", "extreme*", "angle*"})


class GuideTable(Table):
    """A straight guide of a link or of the frame."""

    through: v.Point = key("a point of the guide", [0, 0])
    angle: v.Angle = key("its direction from the x axis", "0 deg")


class FrameTable(BaseModel):
    """The fixed link: every key but number is a guide's name or a fixed point's letter (not P, p, Π, π)."""

    model_config = ConfigDict(defer_build=True, extra="allow")
    __pydantic_extra__: dict[
        str,
        Annotated[
            Annotated[v.Point, Tag("point*")] | Annotated[GuideTable, Tag("guide*")],
            Discriminator(_place),
        ],
    ] = Field(init=False)

    number: v.LinkNumber = key("the number of the fixed link", 6, 0)

    @property
    def points(self) -> dict[str, complex]:
        """The fixed points, m."""
        return {name: p for name, p in self.__pydantic_extra__.items() if isinstance(p, complex)}

    @property
    def guides(self) -> dict[str, GuideTable]:
        """The fixed guides."""
        return {name: g for name, g in self.__pydantic_extra__.items() if isinstance(g, GuideTable)}


class SlideTable(Table):
    """A sliding pair: on which link, along which guide, and which way the pin lies along it."""

    on: v.Target = key('the number of the link it slides on, or "frame"', 3)
    along: v.Text = key("two letters of that link, from the first to the second, or a guide", "BC")
    offset: v.Length = key(
        "how far the slider's own x axis lies to the left of the guide", None, 0.0
    )
    angle: v.Angle = key("by how much the slider's own x axis is turned from the guide", None, 0.0)
    side: v.Sense | None = key("which way the pin lies along the guide", "+", None)
    flips_at: v.Angles | None = key("crank angles at which the side changes", ["90 deg"], None)


class LinkTable(Table):
    """A moving link."""

    number: v.LinkNumber = key("the number of the link", 1)
    name: v.Text = key("what the link is called", "crank", "")
    points: dict[str, v.Point] = Field(
        default_factory=dict,
        description="letters and their places in the link's own axes; P, p, Π, π are kept for poles",
    )
    guides: dict[str, GuideTable] = Field(
        default_factory=dict, description="guides that move with the link"
    )
    slides: Annotated[
        Annotated[SlideTable, Tag("one*")] | Annotated[list[SlideTable], Tag("several*")],
        Discriminator(_slides),
    ] = Field(default_factory=list, description="its sliding pairs: a table, or a list of tables")
    side: v.LinkSide | None = key(
        "where the inner pin of a dyad of turning pairs lies", "left of AC", None
    )
    flips_at: v.Angles | None = key("crank angles at which the side changes", ["90 deg"], None)
    mass: v.Mass | None = key("its mass", "25 kg", None)
    J: v.Inertia | None = key("its moment of inertia about the mass centre", "0.02 kg*m^2", None)
    centre: v.Text | None = key(
        "the letter of its mass centre; left out, its only point that is no turning pair",
        "S2",
        None,
    )

    @property
    def pairs(self) -> list[SlideTable]:
        """The sliding pairs as a list."""
        return [self.slides] if isinstance(self.slides, SlideTable) else self.slides


class TaskTable(Table):
    """A task that gives the lengths of a mechanism."""

    kind: v.TaskKind = key("the kind of mechanism", "rocker")
    K_v: v.Ratio = key("ratio of the mean speeds of the two strokes", 1.45)
    stroke: v.PositiveLength = key("the stroke of the slider", "95 mm")
    OB: v.PositiveLength = key("the distance of the fixed pivots", "480 mm")


class ExtremeTable(Table):
    """The position in which a point is as far as it comes."""

    point: v.Text = key("the letter of the point", "D")
    at: v.At = key("where it is then", "left")


class DriveTable(Table):
    """The driving link, its motion, and the row of positions."""

    link: v.LinkNumber = key("the number of the driving link", 1)
    speed: v.Speed = key("its angular speed, positive", "380 rpm")
    acceleration: v.Spin = key(
        "its angular acceleration in the sense of turning: positive when it speeds up, negative when it slows",
        "20 rad/s^2",
        0.0,
    )
    turns: v.Turns = key("which way it turns", "clockwise", v.COUNTERCLOCKWISE)
    positions: v.Count = key("how many positions there are in a turn", 12, 12)
    first: v.First = key("the number of the zero position", 1, 0)
    extra: v.Extra = key(
        'positions beside the row: "other extreme", or crank angles', [v.OTHER_EXTREME], ()
    )
    accelerations: v.Accelerations = key("the positions with an acceleration plan", [2, 6], ())
    zero: Annotated[
        Annotated[v.Angle, Tag("angle*")] | Annotated[ExtremeTable, Tag("extreme*")],
        Discriminator(_zero),
    ] = key("the zero position: a crank angle, or an extreme of a point", None, 0.0)


class PlansTable(Table):
    """What is drawn, and how."""

    velocities: v.Velocities = key("velocity plans as they are, or turned by 90°", None, "direct")
    velocity_pole: v.Poles = key(
        "a velocity plan for each position, or all of them from a common pole", None, "own"
    )
    trajectories: v.Letters = key("points whose paths are drawn", ["C"], ())
    main: v.Position | None = key("the position drawn in heavy lines", 2, None)


class ScalesTable(Table):
    """Scale factors that are fixed; the rest are chosen from the standard row."""

    mu_l: v.MuL | None = key('m/mm, or "1:5"', "0.005 m/mm", None)
    mu_v: v.MuV | None = key(f'(m/s)/mm, or "{v.MU_L_OMEGA}"', "0.25 (m/s)/mm", None)
    mu_a: v.MuA | None = key("(m/s²)/mm", "12.5 (m/s^2)/mm", None)
    OA: v.Drawn | None = key("drawn length of the crank, instead of mu_l", "60 mm", None)
    pa: v.Drawn | None = key("drawn velocity of the crank pin, instead of mu_v", "60 mm", None)
    pi_a: v.Drawn | None = key(
        "drawn acceleration of the crank pin, instead of mu_a", "60 mm", None
    )


class HandTable(Table):
    """How well lengths are read."""

    name: v.HandName = key("who draws: exact, cad, careful, student", "student", "exact")
    seed: v.Seed = key("which of that hand's drawings", 7, 0)
    ruler: v.Ruler | None = key(
        'the division that lengths are read to, or "exact"; left out: the hand\'s own',
        "0.1 mm",
        None,
    )


class SheetTable(Table):
    """A sheet, and what is placed on it, in order."""

    format: v.Format = key("the format of the sheet", "A1", "A1")
    place: v.Places | None = key(
        "the plans on it; left out: all that the scene calls for", ["positions", "velocities"], None
    )


class TitleBlockTable(Table):
    """What is written into the title block."""

    designation: v.Text = ""
    name: v.Text = ""
    organisation: v.Text = ""
    drawn_by: v.Text = ""
    checked_by: v.Text = ""
    standards_by: v.Text = ""
    approved_by: v.Text = ""
    material: v.Text = ""
    letter: v.Text = ""
    mass: v.Text = ""
    scale: v.Text = ""


class Head(Table):
    """The keys before the first section."""

    title: v.Title = key("what the mechanism is", "Кривошипно-ползунный механизм")
    language: v.Language = key("the language of the sheets", "en", "ru")


class SceneFile(Head):
    """A scene of graphic_tmm: a mechanism, its drive, and what is drawn of it."""

    lengths: dict[str, v.PlainLength] = Field(default_factory=dict, description="named lengths")
    task: TaskTable | None = key("lengths found from a task", None, None)
    frame: FrameTable | None = key("the fixed link", None, None)
    link: list[LinkTable] = Field(default_factory=list, description="the moving links, in order")
    drive: DriveTable | None = key("the driving link and its motion", None, None)
    plans: PlansTable = Field(default_factory=PlansTable)
    diagrams: DiagramsTable | None = key("kinematic diagrams of a point", None, None)
    indicator: IndicatorTable | None = key("the indicator diagram of a cylinder", None, None)
    flywheel: FlywheelTable | None = key("the flywheel of a machine", None, None)
    effects: EffectsTable = Field(default_factory=EffectsTable)
    load: list[LoadTable] = Field(default_factory=list, description="forces and moments on links")
    forces: ForcesTable | None = key("kinetostatics and the lever", None, None)
    friction: FrictionTable | None = key("friction of the pairs", None, None)
    engine: EngineTable | None = key("the forces of an engine's crank mechanism", None, None)
    cam: CamTable | None = key("a cam", None, None)
    gears: GearsTable | None = key("a pair of gears", None, None)
    planetary: PlanetaryTable | None = key("a planetary train", None, None)
    scales: ScalesTable = Field(default_factory=ScalesTable)
    hand: HandTable = Field(default_factory=HandTable)
    sheet: list[SheetTable] = Field(default_factory=list, description="the sheets")
    title_block: TitleBlockTable = Field(default_factory=TitleBlockTable)


_TABLES: dict[str, type[BaseModel]] = {
    "frame": FrameTable,
    "link": LinkTable,
    "slides": SlideTable,
    "task": TaskTable,
    "drive": DriveTable,
    "zero": ExtremeTable,
    "plans": PlansTable,
    "diagrams": DiagramsTable,
    "indicator": IndicatorTable,
    "cover_points": TracedTable,
    "shaft_points": TracedTable,
    "cover_strokes": StrokeTable,
    "shaft_strokes": StrokeTable,
    "flywheel": FlywheelTable,
    "effects": EffectsTable,
    "load": LoadTable,
    "forces": ForcesTable,
    "friction": FrictionTable,
    "engine": EngineTable,
    "cam": CamTable,
    "gears": GearsTable,
    "planetary": PlanetaryTable,
    "scales": ScalesTable,
    "hand": HandTable,
    "sheet": SheetTable,
    "title_block": TitleBlockTable,
}


def keys_of(path: tuple[str | int, ...]) -> dict[str, FieldInfo]:
    """Return the keys of the table at a path (of a guide, if the table has no name of its own)."""
    names = [part for part in path if isinstance(part, str)]
    model = _TABLES.get(names[-1], GuideTable) if names else SceneFile
    return model.model_fields


def schema() -> dict[str, Any]:
    """Return the JSON Schema of a scene file, as shipped in ``scene.schema.json``."""
    found = _without_null(SceneFile.model_json_schema())
    assert isinstance(found, dict)
    return found


def _without_null(node: Any) -> Any:
    """TOML has no null: a key is there or it is not."""
    if isinstance(node, list):
        return [_without_null(item) for item in node if item != {"type": "null"}]
    if not isinstance(node, dict):
        return node
    kept = {
        key: _without_null(item)
        for key, item in node.items()
        if not (key == "default" and item is None)
    }
    alternatives = kept.get("anyOf")
    if isinstance(alternatives, list) and len(alternatives) == 1:
        del kept["anyOf"]
        kept = alternatives[0] | kept
    return kept
