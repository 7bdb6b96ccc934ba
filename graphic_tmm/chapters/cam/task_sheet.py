"""What a task asks of a cam, a sentence each; the diagram of a law that it gives by points."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cam.given import given, stated
from graphic_tmm.chapters.cam.scheme import scheme as drawn_scheme
from graphic_tmm.chapters.cam.task import ASKED, FlatFollower
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.given import figure
from graphic_tmm.readers.task_sheet import Listed, TaskSheet
from graphic_tmm.scene.records import Scene


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the diagrams of the follower, the least radius, the profile."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    flat = isinstance(order.follower, FlatFollower)
    yield _(_DIAGRAMS)
    yield _(_CONVEX if flat else _RADIUS)
    yield _(_FACE if flat else _PROFILE)


def scheme(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the scheme of the mechanism."""
    yield speaking(language)(_SCHEME)


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the acceleration diagrams of laws that are given by points."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    laws = {"rise": (order.rise_law, _RISE), "return": (order.return_law, _RETURN)}
    for name, (law, title) in laws.items():
        if law.points and (name == "rise" or law.points != order.rise_law.points):
            heads = ("φ/φ_{0}", *(figure(share, language) for share, _ in law.points))
            row = ("a", *(figure(size, language) for _, size in law.points))
            yield Listed(f"law-{name}", _(title), heads, (row,))


_DIAGRAMS = said(
    "Diagrams of the follower's displacement, of dS/dφ and of d²S/dφ² over a turn of the cam are drawn."
)
_RADIUS = said(
    "The region of the cam's centre and the least radius are found by the largest pressure angle "
    "allowed; the radius is chosen."
)
_CONVEX = said(
    "The least radius is found at which the profile is convex everywhere; the radius is chosen."
)
_PROFILE = said(
    "The radius of the roller is chosen; the theoretical and the working profile of the cam are drawn."
)
_FACE = said("The profile of the cam and the width of the face are drawn.")
_SCHEME = said("The scheme of the cam mechanism is drawn.")
_RISE = said("Acceleration of the follower by shares of the rise (in proportion)")
_RETURN = said("Acceleration of the follower by shares of the return (in proportion)")


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    listed=listed,
    scheme=drawn_scheme,
    wanted={"cam": asks, "cam scheme": scheme},
)
