"""The drawing board of the theory of machines and mechanisms: plans as recorded constructions.

    import graphic_tmm as tmm

    scene = tmm.read("windrower")               a scene: a name, a path, TOML text, tables
    tmm.scenes()                                the names of those that come with the package
    scene.with_({"drive.speed": "400 rpm"})     the same with other values
    drawn = tmm.draw(scene, hand="student")     drawn by a hand; nothing is laid out yet
    drawn.table("velocities")                   arrays of mm and SI; to_records, to_pandas
    drawn.results["J_fly"]                      a figure with its unit; scales, facts, warnings
    drawn.steps("velocities", 3)                what a student does, step by step
    drawn.sheets[0].save("sheet.svg")           sheets; drawn.save("page.html"), drawn.note("note.pdf")
    drawn.check("readings.csv")                 a drawing made by hand, judged
    drawn.plot("diagrams")                      curves, by matplotlib
    tmm.motion(scene, at)                       positions, velocities, accelerations at any places
    tmm.Board()                                 a construction of your own

These names, their parameters and what they return are stable: a change that breaks a program comes with a new
major version (before 1.0: a new minor one) and is listed in CHANGES.md. All else in the package may change.
More, with examples: face/README.md in the folder of the package.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphic_tmm.errors import AbsentError as AbsentError
    from graphic_tmm.errors import BareError as BareError
    from graphic_tmm.errors import ConstructionError as ConstructionError
    from graphic_tmm.errors import Fault as Fault
    from graphic_tmm.errors import MissingError as MissingError
    from graphic_tmm.errors import SceneError as SceneError
    from graphic_tmm.errors import SheetError as SheetError
    from graphic_tmm.errors import StructureError as StructureError
    from graphic_tmm.errors import TmmError as TmmError
    from graphic_tmm.errors import ViewError as ViewError
    from graphic_tmm.face.board import Board as Board
    from graphic_tmm.face.checks import Check as Check
    from graphic_tmm.face.checks import Mistake as Mistake
    from graphic_tmm.face.checks import Verdict as Verdict
    from graphic_tmm.face.drawn import Drawn as Drawn
    from graphic_tmm.face.drawn import draw as draw
    from graphic_tmm.face.motion import motion as motion
    from graphic_tmm.face.reading import read as read
    from graphic_tmm.face.reading import scenes as scenes
    from graphic_tmm.face.sheets import Sheet as Sheet
    from graphic_tmm.face.steps import Step, Steps
    from graphic_tmm.face.tables import Column as Column
    from graphic_tmm.face.tables import Quantity
    from graphic_tmm.face.tables import Table as Table
    from graphic_tmm.readers.any_angles.results import Motion as Motion
    from graphic_tmm.readers.any_angles.results import PointMotion as PointMotion
    from graphic_tmm.scene.records import Scene as Scene

    __version__: str

_HOMES = {
    "AbsentError": "errors",
    "BareError": "errors",
    "Board": "face.board",
    "Check": "face.checks",
    "Column": "face.tables",
    "ConstructionError": "errors",
    "Drawn": "face.drawn",
    "Fault": "errors",
    "Mistake": "face.checks",
    "MissingError": "errors",
    "Motion": "readers.any_angles.results",
    "PointMotion": "readers.any_angles.results",
    "Quantity": "face.tables",
    "Scene": "scene.records",
    "SceneError": "errors",
    "Sheet": "face.sheets",
    "SheetError": "errors",
    "Step": "face.steps",
    "Steps": "face.steps",
    "StructureError": "errors",
    "Table": "face.tables",
    "TmmError": "errors",
    "Verdict": "face.checks",
    "ViewError": "errors",
    "draw": "face.drawn",
    "motion": "face.motion",
    "read": "face.reading",
    "scenes": "face.reading",
}
__all__ = [
    "AbsentError",
    "BareError",
    "Board",
    "Check",
    "Column",
    "ConstructionError",
    "Drawn",
    "Fault",
    "MissingError",
    "Mistake",
    "Motion",
    "PointMotion",
    "Quantity",
    "Scene",
    "SceneError",
    "Sheet",
    "SheetError",
    "Step",
    "Steps",
    "StructureError",
    "Table",
    "TmmError",
    "Verdict",
    "ViewError",
    "draw",
    "motion",
    "read",
    "scenes",
]


def __dir__() -> list[str]:
    """Return the public names, for completion."""
    return sorted([*__all__, "__doc__", "__version__"])


if not TYPE_CHECKING:  # whoever checks types sees the imports above

    def __getattr__(name):
        """Import a public name on first use, so that the package itself is light."""
        from importlib import import_module, metadata

        if name == "__version__":
            return metadata.version("graphic-tmm")
        if name not in _HOMES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
