"""What a sheet shows of a cam: diagrams, the region of centres, profiles, pressure angle, results."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam.flat import Convexity
from graphic_tmm.chapters.cam.ink import ProfileNames, draw_profile_ink
from graphic_tmm.chapters.cam.ink_centre import CentreNames, draw_centre_ink
from graphic_tmm.chapters.cam.ink_flat import draw_convexity_ink
from graphic_tmm.chapters.cam.ink_graphs import CamNames, draw_cam_graph
from graphic_tmm.chapters.cam.ink_rocker import draw_rocker_ink
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.chapters.cam.table import cam_columns, cam_names
from graphic_tmm.language.captions import CAPTIONS
from graphic_tmm.language.words import fixed, number, unit
from graphic_tmm.paper.arranging import captioned, stacked
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.result_table import (
    SIZE,
    result_table,
)
from graphic_tmm.paper.ruled import table
from graphic_tmm.parts import Part

LIMITED = ("cam pressure",)


def cam_views(part: Part, lettered: bool) -> list[Drawing]:
    """Return the views of a cam."""
    made, language = part.made, part.scene.language
    assert isinstance(made, Cam)
    names = cam_names(made)
    rows = cam_columns(part)
    motion, *limits = _diagrams(part, made, names, lettered)
    return [
        motion,
        _profile(part, made, names, lettered),
        _centre(part, made, names, lettered),
        *limits,
        result_table("cam", rows, names, language, upright=True),
        _results(part),
    ]


def _one(part: Part, mark: Mark) -> float:
    return float(part.reading[mark][0, 0])


def _diagrams(part: Part, made: Cam, names: Sequence[str], lettered: bool) -> list[Drawing]:
    """Return the diagrams of motion one below the other, those of pressure angle and curvature beside them."""
    language = part.scene.language
    words, order = CAPTIONS[language], made.order
    ends, at = [], 0.0
    for k, angle in enumerate((order.rise, order.upper_dwell, order.fall, order.lower_dwell)):
        at += angle
        if angle > 0.0:
            ends.append((f"φ_{{{k + 1}}} = {number(angle, language)}°", at))
    first: list[Drawing] = []
    second: list[Drawing] = []
    axes = dict.fromkeys(f.view for f in part.construction.figures if f.kind == "axes")
    for view in axes:
        symbol = words.get(f"symbol {view}", words.get("symbol cam", "y"))
        levels = []
        if view in LIMITED:
            mu = made.pressure.chart.mu if made.pressure is not None else None
            back = order.pressure_return or order.pressure
            if mu is not None:
                scale = _one(part, mu)
                levels = [
                    (order.pressure / scale, f"[α] = {number(order.pressure, language)}°"),
                    (-back / scale, f"[α] = {number(back, language)}°"),
                ]
        graph = draw_cam_graph(
            part.construction,
            part.reading,
            view,
            CamNames(names, symbol, "φ", ends if view == "cam S" else (), levels),
            _title(view, language),
            lettered=lettered,
        )
        shown = captioned(graph, _title(view, language), _scale(part, view))
        (first if view in ("cam S", "cam dS", "cam ddS") else second).append(shown)
    return [stacked("cam-diagrams", first)] + ([stacked("cam-limits", second)] if second else [])


def _title(view: str, language: str) -> str:
    words = CAPTIONS[language]
    return words.get(view, words["cam integration"])


def _scale(part: Part, view: str) -> str:
    language = part.scene.language
    scale = part.scales().get(view)
    if scale is None:
        return ""
    return f"{scale.symbol} = {number(scale.value, language)} {unit(scale.unit, language)}".rstrip()


def _mm(part: Part, mark: Mark) -> str:
    language = part.scene.language
    return f"{fixed(1000.0 * _one(part, mark), 1, language)} {unit('mm', language)}"


def _centre(part: Part, made: Cam, names: Sequence[str], lettered: bool) -> Drawing:
    language = part.scene.language
    words = CAPTIONS[language]
    limits = [made.order.pressure, made.order.pressure_return or made.order.pressure]
    told = CentreNames(
        names,
        "S",
        "dS/dφ",
        f"r_{{0min}} = {_mm(part, made.least)}",
        f"r_{{0}} = {_mm(part, made.r0)}",
        (f"{number(limits[0], language)}°", f"{number(limits[1], language)}°"),
    )
    title = words["cam centre"]
    if isinstance(made.centre, Convexity):
        view = draw_convexity_ink(part.reading, made, told, title, lettered=lettered)
    else:
        draw = draw_rocker_ink if isinstance(made.path, Lever) else draw_centre_ink
        view = draw(part.construction, part.reading, made, told, title, lettered=lettered)
    lines = [f"r_{{0min}} = {_mm(part, made.least)}, r_{{0}} = {_mm(part, made.r0)}"]
    return captioned(view, title, _lengths(part, made), *lines)


def _lengths(part: Part, made: Cam) -> str:
    language, mu = part.scene.language, made.profile.mu
    return f"μ_l = {number(_one(part, mu), language)} {unit('m/mm', language)}"


def _profile(part: Part, made: Cam, names: Sequence[str], lettered: bool) -> Drawing:
    language = part.scene.language
    words = CAPTIONS[language]
    roller = "r"
    if made.roller is not None:
        roller = f"r = {_mm(part, made.roller.radius)}"
    told = ProfileNames(names, "r_{0}", roller, words["theoretical"], words["working"])
    title = words["cam profile"]
    view = draw_profile_ink(part.reading, made, told, title, lettered=lettered)
    return captioned(view, title, _lengths(part, made))


def _results(part: Part) -> Drawing:
    language = part.scene.language
    words, rows = CAPTIONS[language], []
    for name, (value, of) in part.results().items():
        in_mm = of == "m"
        figure = fixed(1000.0 * value, 2, language) if in_mm else fixed(value, 2, language)
        rows.append([words[name], figure, unit("mm" if in_mm else of, language)])
    heads = [words["value"], words["results of"], words["unit"]]
    align = ["left", "centre", "left"]
    return table("table-cam-results", words["cam"], heads, rows, size=SIZE, align=align)
