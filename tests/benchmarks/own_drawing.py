"""What a person's own drawing is read to, off photographs of 12 megapixels, and what that costs in a browser.

`python tests/benchmarks/own_drawing.py` takes A1 sheets and single plans by cameras of known place (tilted, in
shade, with noise, JPEG 80), lets the page's program find their frames (node), and clicks points up to a dot of
the four-fold loupe off. About eight minutes; `--quick` takes two of each kind.
"""

from __future__ import annotations

import io
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from clock import Row, show
from PIL import Image
from support import photographs
from support.browser import Opened, launched
from support.pages import on_sheets
from support.photographs import CORNERS, DOTS, FRAME, PAPER, Camera
from support.scripts import run

from graphic_tmm.page.page import page
from graphic_tmm.page.practice.own import seeking

COUNT = 10
LOUPE = 0.25
"""A dot of the loupe, dots of the photograph."""
ROUGH = 20.0
"""How far corners are clicked from those of a frame, dots of the photograph."""
DUE = {"A1": 0.2, "A1, lens and sag": 0.5, "single plans": 0.3}
"""Of 95 points in 100, mm."""
SEEN, CLICK = 3.0, 0.016
"""Seconds until a photograph is seen flat; of a click."""
PLAN = (0.0, 0.0, 240.0, 180.0)
FOUND = """
import { refinedFrame } from "./own/frame.js";
import { pinholeOf } from "./own/lens.js";
import { Shot } from "./own/shot.js";
const bytes = readFileSync(files[0]);
const data = new Uint8ClampedArray(bytes.buffer, bytes.byteOffset, bytes.length);
const image = { ...asked.size, data };
const shot = asked.lines
  ? refinedFrame(image, asked.box, asked.corners, asked.seeking).shot
  : new Shot(asked.box, asked.corners, pinholeOf(image));
tell(asked.points.map(([x, y]) => shot.onSheet(x, y)));
"""


class Case(NamedTuple):
    """A photograph: its kind, its camera, what was drawn, the rectangle that is clicked, if it has lines."""

    kind: str
    camera: Camera
    drawn: np.ndarray
    box: tuple[float, float, float, float]
    lines: bool


def corners_of(box: tuple[float, float, float, float]) -> np.ndarray:
    left, bottom, right, top = box
    return np.array([left + 1j * bottom, right + 1j * bottom, right + 1j * top, left + 1j * top])


def cases(count: int) -> Iterator[Case]:
    random = np.random.default_rng(17)
    for kind in DUE:
        for k in range(count):
            tilt = tuple(random.uniform(-12, 12, 3))
            if kind == "single plans":
                # every other one drawn within a rectangle, the others alone on a paper of known size
                lines = k % 2 == 0
                box = PLAN if lines else (0.0, 0.0, 297.0, 210.0)
                middle = (box[2] / 2, box[3] / 2)
                camera = Camera(tilt, 420, 4300, 4000, 3000, middle=middle)
                yield Case(kind, camera, paper(box, lines=lines), box, lines)
                continue
            camera = Camera(tilt, 1150, 4300, 4000, 3000)
            if kind != "A1":
                lens, sag = random.uniform(-0.002, 0.002), random.uniform(-2, 2)
                camera = camera._replace(lens=lens, sag=sag)
            yield Case(kind, camera, photographs.sheet(), FRAME, True)


def paper(box: tuple[float, float, float, float], *, lines: bool) -> np.ndarray:
    """A paper with a rectangle in pencil, 15 mm within its edges, or with nothing."""
    rim = 15 if lines else 0
    width, height = box[2] - box[0] + 2 * rim, box[3] - box[1] + 2 * rim
    made = np.full((int(height * DOTS), int(width * DOTS)), PAPER, dtype=np.float32)
    if lines:
        photographs.box(made, rim, rim, rim + box[2], rim + box[3], 0.5)
        made = PAPER - (PAPER - made) * 0.5
    return made


def read(case: Case, seed: int, folder: Path) -> np.ndarray:
    """Return how far points are off, mm from the pole that was clicked first."""
    random = np.random.default_rng(seed)
    camera, offset = case.camera, 0j
    if case.kind == "single plans" and case.lines:
        offset = 15 + 15j
    moved = camera._replace(middle=(camera.middle[0] + offset.real, camera.middle[1] + offset.imag))
    taken = photographs.photograph(moved, case.drawn, seed=seed)
    image = np.asarray(Image.open(io.BytesIO(photographs.jpeg(taken))))
    file = folder / "photo.raw"
    file.write_bytes(np.dstack([image, np.full(image.shape[:2], 255, np.uint8)]).tobytes())
    left, bottom, right, top = case.box
    pole = complex(random.uniform(left, right), random.uniform(bottom, top))
    away = random.uniform(20, 120, 40) * np.exp(1j * random.uniform(0, 2 * np.pi, 40))
    spots = pole + away
    inside = (spots.real > left) & (spots.real < right) & (spots.imag > bottom) & (spots.imag < top)
    spots = np.array([pole, *spots[inside]])
    # the frame of a sheet roughly; the corners of a single plan by the loupe
    by = ROUGH if case.kind != "single plans" else LOUPE
    clicked = moved.seen(corners_of(case.box) + offset) + slips(random, 4, by)
    points = moved.seen(spots + offset) + slips(random, spots.size, LOUPE)
    asked = {
        "size": {"width": camera.columns, "height": camera.rows},
        "box": case.box,
        "corners": photographs.pairs(clicked).tolist(),
        "points": photographs.pairs(points).tolist(),
        "lines": case.lines,
        "seeking": seeking(),
    }
    found = np.array([complex(*one) for one in run(FOUND, asked, file)])
    return abs((found - found[0]) - (spots - spots[0]))[1:]


def slips(random: np.random.Generator, count: int, by: float) -> np.ndarray:
    return random.uniform(-by, by, count) + 1j * random.uniform(-by, by, count)


def precision(count: int) -> Iterator[Row]:
    off: dict[str, list[np.ndarray]] = {kind: [] for kind in DUE}
    with tempfile.TemporaryDirectory() as folder:
        for seed, case in enumerate(cases(count)):
            off[case.kind].append(read(case, seed, Path(folder)))
    for kind, rows in off.items():
        whole = np.concatenate(rows)
        told = (
            f"{np.quantile(whole, 0.95):.3f} mm in 95 % of {whole.size}, {whole.max():.3f} at most"
        )
        holds = bool(np.quantile(whole, 0.95) <= DUE[kind])
        yield Row(f"{kind}, {len(rows)} photographs", told, f"{DUE[kind]:g} mm", holds)


SPENT = """async () => {
  const desk = document.querySelector("#own .desk");
  const { left, top, width, height } = desk.getBoundingClientRect();
  const take = document.querySelector("#own .own-take");
  const spent = [];
  for (let k = 0; k < 24; k += 1) {
    const at = { clientX: left + width * (0.4 + 0.008 * k), clientY: top + height * (0.4 + 0.006 * k) };
    const told = { ...at, bubbles: true, button: 0, pointerId: 1, pointerType: "mouse" };
    desk.setPointerCapture = () => {};
    const begun = performance.now();
    desk.dispatchEvent(new PointerEvent("pointerdown", told));
    desk.dispatchEvent(new PointerEvent("pointerup", told));
    const tapped = performance.now() - begun;
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    const again = performance.now();
    take.click();
    spent.push(tapped + performance.now() - again);
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
  }
  return spent;
}"""


def costs() -> Iterator[Row]:
    """Yield what a browser needs for a photograph of the windrower's first sheet, and for a click."""
    camera = Camera((9, -7, 4), 1150, 4300, 4000, 3000)
    photo = photographs.jpeg(photographs.photograph(camera, photographs.sheet()))
    with tempfile.TemporaryDirectory() as folder, launched() as browser:
        file = Path(folder) / "page.html"
        file.write_text(page(*on_sheets("windrower", "ru"), practised=True), encoding="utf-8")
        tab = Opened(browser, file, "#own")
        own: Any = tab.page.locator("#own")
        begun = time.perf_counter()
        upload = {"name": "photo.jpg", "mimeType": "image/jpeg", "buffer": photo}
        own.locator("input[type=file]").set_input_files(files=[upload])
        tab.page.wait_for_selector("#own.opened")
        opened = time.perf_counter() - begun
        desk = own.locator(".desk")
        for at in camera.seen(CORNERS):
            tab.page.wait_for_timeout(100)
            box = desk.bounding_box()
            x, y, zoom = map(float, desk.get_attribute("data-seen").split())
            begun = time.perf_counter()
            tab.page.mouse.click(
                box["x"] + 1 + (at.real - x) * zoom, box["y"] + 1 + (at.imag - y) * zoom
            )
        tab.page.wait_for_selector("#own.laid")
        flat = time.perf_counter() - begun
        spent = sorted(tab.page.evaluate(SPENT))
        tab.close()
    yield Row("a photograph, opened", f"{opened:.2f} s", "")
    yield Row("opened and laid flat", f"{opened + flat:.2f} s", f"{SEEN:g} s", opened + flat < SEEN)
    middle, worst = spent[len(spent) // 2], spent[int(0.95 * len(spent))]
    told = f"{middle:.1f} ms, {worst:.1f} in 95 %"
    yield Row("a click, and taking it", told, f"{1000 * CLICK:g} ms", worst < 1000 * CLICK)


if __name__ == "__main__":
    show("A drawing of one's own", [*costs(), *precision(2 if "--quick" in sys.argv else COUNT)])
