"""What a scene asks for, after reading: frozen records in SI, nothing of TOML left."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pkgutil import resolve_name
from typing import Any

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined
from graphic_tmm.language.units import retold
from graphic_tmm.mechanism.records import Mechanism, Row
from graphic_tmm.scene.author import Author
from graphic_tmm.scene.drawing import Hand, Plans
from graphic_tmm.scene.drawing import Scales as Scales
from graphic_tmm.scene.drawing import SheetOrder as SheetOrder
from graphic_tmm.scene.length_task import Task
from graphic_tmm.scene.registry import called_by, sections


@dataclass(frozen=True, repr=False)
class Scene(Plans, Hand):
    """A scene: the mechanism, its motion, the plans wanted and the sheets they are placed on.

    What ``[plans]`` and ``[hand]`` say is in it by the fields that they declare. ``author``: what the author of
    the note says. ``tasks``: what chapters are asked, by section (`tasks.SectionKey`). ``letters``: how high
    letters of points, titles, numbers are, mm; None: by the formats of the sheets. ``remarks``: what of the
    file comes to nothing, and defaults that matter, a line each. ``left_out``: chapters that have no result,
    which it asks for no more, and why. ``told``: the keys that the file writes in its sections, as section.key,
    each with its line. ``doc``: all that is written, as TOML gives it.
    """

    source: str
    title: str
    language: str
    mechanism: Mechanism | None = None
    row: Row = field(default_factory=Row)
    tasks: Mapping[str, Any] = field(default_factory=dict)
    scales: Scales = field(default_factory=Scales)
    sheets: tuple[SheetOrder, ...] = (SheetOrder(),)
    title_block: Mapping[str, str] = field(default_factory=dict)
    print_check: bool = True
    letters: tuple[float, float, float] | None = None
    task: Task | None = None
    author: Author = field(default_factory=Author)
    remarks: tuple[str, ...] = ()
    left_out: Mapping[str, str] = field(default_factory=dict)
    told: Mapping[str, int] = field(default_factory=dict)
    doc: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)

    def __repr__(self) -> str:
        links = "" if self.mechanism is None else f", {len(self.mechanism.links)} moving links"
        tasks = "".join(f", [{name}]" for name, task in self.tasks.items() if task is not None)
        return f"<Scene {self.title!r} of {self.source}{links}{tasks}>"

    @property
    def at_rest(self) -> bool:
        """Whether its mechanism stands."""
        return self.mechanism is not None and self.mechanism.at_rest

    @cached_property
    def cache(self) -> dict[Any, Any]:
        """What follows from this scene alone and takes long to find, kept beside it by what it is called."""
        return {}

    def __getstate__(self) -> dict[str, Any]:
        """Return what another process needs: what was found out of the scene is found there again."""
        return {name: value for name, value in self.__dict__.items() if name != "cache"}

    def with_(self, values: Mapping[str, object] | None = None, /, **named: object) -> Scene:
        """Return the scene that says something else at some of its keys; this one stays as it is.

        Parameters
        ----------
        values : mapping, optional
            By key, written as in a table of variants: ``"drive.speed"``, ``"link 3, mass"`` or
            ``"links.3.mass"``, a name of ``[lengths]`` alone (``"OA"`` or ``"links.1.OA"``), a section
            (``"hand"``). A value is what a scene holds: a number in SI units, a text with its unit
            (``"95 mm"``), true or false, a list, a table; None takes out what is written there.
        **named
            The same, for keys that Python can spell: ``OA="120 mm"``, ``language="en"``.

        Returns
        -------
        Scene
            Read anew from what is written, so all that a scene file is refused for is refused here.

        Raises
        ------
        SceneError
            With every fault, each at its key.

        Examples
        --------
        >>> from graphic_tmm import read
        >>> faster = read("windrower").with_({"drive.speed": "400 rpm", "task.stroke": 0.1})
        >>> round(faster.mechanism.drive.speed, 2)
        41.89
        """
        # what reads scenes stands above what they are
        changed: Scene = resolve_name("graphic_tmm.scene.read:otherwise")(
            self, {**(values or {}), **named}
        )
        return changed

    def spoken_in(self, language: str) -> Scene:
        """Return the scene in another language, in its own units; "": as it is."""
        other = retold(self.language, language) if language else self.language
        return self if other == self.language else replace(self, language=other)

    def __str__(self) -> str:
        return f"<Scene {self.title!r}: {self.source}>"

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        """Write for a notebook what scene it is; all that it says would fill the screen."""
        printer.text(str(self))

    def asking(self, **tasks: object) -> Scene:
        """Return the scene asking for other tasks of chapters, by section; None: not asking."""
        asked = {**self.tasks, **tasks}
        return replace(self, tasks={name: one for name, one in asked.items() if one is not None})

    def located(self, error: StructureError) -> StructureError:
        """Return what a plan refuses with the file, and the keys and the line of which it speaks."""
        told = [key for key in error.keys if key in self.told] or list(error.keys[:1])
        if not told:
            return StructureError(
                joined(": ", (self.source, error.args[0])), pictures=error.pictures
            )
        above = (told[0], told[0].rpartition(", ")[0], told[0].rpartition(".")[0])
        line = next((self.told[key] for key in above if key in self.told), 0)
        place = f"{self.source}:{line}" if line else self.source
        section, _, key = re.sub(r" \d+, ", ".", told[0]).partition(".")
        known = error.head.partition(",")[0] in (section, key)
        says = error.says if known else error.args[0]
        whole = joined(": ", (place, ", ".join(told), says))
        return StructureError(whole, *told, pictures=error.pictures)

    @property
    def shown_places(self) -> frozenset[str]:
        """What the sheets show: their places."""
        return frozenset(place for sheet in self.sheets for place in sheet.place)

    @property
    def called(self) -> frozenset[str]:
        """What the scene calls for, whether or not a sheet shows it: places of its sections, and plans."""
        found = {name for one in sections() if one.name in self.tasks for name in called_by(one)}
        if self.row.accelerations:
            found.add("accelerations")
        return self.shown_places | found
