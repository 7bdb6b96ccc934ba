"""What effects cost: steps of the log and time, with and without each that a scene names."""

from __future__ import annotations

from functools import partial
from typing import Any

from clock import ROOT, Row, in_turns, show
from support import effects
from support.boards import drawn_of

from graphic_tmm.board.execute import prepare
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

SCENES = ("windrower", "crank-press")


def running(scene: Scene) -> tuple[int, Any]:
    """Return the number of a scene's steps, and a call that runs its log."""
    made = drawn_of(scene)
    log = made.project.construction
    program = prepare(log)
    return len(log.steps), partial(program.run, made.given, hand=made.hand)


def rows(name: str) -> list[Row]:
    """Return the lines of one scene: it whole, and without each of its effects (and those that need it)."""
    scene = read(ROOT / "sheets" / name)
    named = effects.named(scene)
    kept: dict[str, set[str]] = {"whole": set(named)}
    for effect in named:
        without = set(named) - {effect}
        kept[effect] = {one for one in without if not effects.needs(scene, one) - without}
    kept["plan of positions alone"] = set()
    runs = {one: running(effects.only(scene, some)) for one, some in kept.items()}
    seconds = in_turns({one: call for one, (_, call) in runs.items()}, rounds=15, least=3)
    count, whole = runs["whole"][0], seconds["whole"]
    found = [Row(f"{name}: {', '.join(named)}", f"{count} steps, {whole * 1e3:.2f} ms")]
    for one, some in kept.items():
        if one == "whole":
            continue
        also = [other for other in named if other not in some and other != one]
        what = (
            one
            if one not in named
            else f"without {one}" + (f" (nor {', '.join(also)})" if also else "")
        )
        steps = runs[one][0]
        ratio = seconds[one] / whole
        found.append(
            Row(f"{name}: {what}", f"{steps} steps ({steps / count:.2f}), time {ratio:.2f}")
        )
    return found


def main() -> None:
    """Print the table."""
    show("effects", [row for name in SCENES for row in rows(name)])


if __name__ == "__main__":
    main()
