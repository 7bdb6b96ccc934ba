/**
 * @typedef {import("./pan.js").Camera} Camera
 * @typedef {(px: number, py: number, touch: boolean) => void} Tap
 */

/** A pointer that moved less is a tap, px. */
const STILL = 6;
/** How much a pixel of the wheel zooms. */
const OF_WHEEL = 0.0016;
/** A turn of the wheel, however quick, zooms by no larger power of e. */
const MOST_TURN = 0.5;
/** What a line or a page of the wheel is, px. */
const LINES = [1, 16, 400];
/** The share of the window that an arrow key moves. */
const ARROW = 0.12;
const STEP = 1.25;

/**
 * Let mouse and fingers move what is seen on an element, and tell of taps.
 * @param {HTMLElement} surface
 * @param {() => Camera} camera
 * @param {() => void} moved
 * @param {Tap} tap
 */
export function listenToHands(surface, camera, moved, tap) {
  /** @type {Map<number, {x: number, y: number}>} */
  const down = new Map();
  let way = 0;

  /** @param {MouseEvent} event */
  function spot(event) {
    const box = surface.getBoundingClientRect();
    return { x: event.clientX - box.left - surface.clientLeft, y: event.clientY - box.top - surface.clientTop };
  }
  surface.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    if (down.size === 0) way = 0;
    else way = Infinity;
    down.set(event.pointerId, spot(event));
    surface.setPointerCapture(event.pointerId);
  });
  surface.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (before === undefined) return;
    const now = spot(event);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    way += Math.hypot(now.x - before.x, now.y - before.y);
    down.set(event.pointerId, now);
    if (other !== undefined) pinch(camera(), other, before, now);
    else if (way > STILL) camera().shift(now.x - before.x, now.y - before.y);
    else return void down.set(event.pointerId, before);
    moved();
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) {
    surface.addEventListener(kind, (event) => {
      const still = down.delete(event.pointerId) && way <= STILL && down.size === 0;
      if (kind === "pointerup" && still) tap(spot(event).x, spot(event).y, event.pointerType === "touch");
    });
  }
  surface.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const by = event.deltaY * (LINES[event.deltaMode] ?? 1);
      const at = spot(event);
      const turn = Math.min(Math.max(by * OF_WHEEL * (event.ctrlKey ? 5 : 1), -MOST_TURN), MOST_TURN);
      camera().zoomAt(Math.exp(-turn), at.x, at.y);
      moved();
    },
    { passive: false },
  );
}

/**
 * @param {Camera} camera
 * @param {{x: number, y: number}} other the finger that stays
 * @param {{x: number, y: number}} before
 * @param {{x: number, y: number}} now
 */
function pinch(camera, other, before, now) {
  const apart = (/** @type {{x: number, y: number}} */ one) => Math.max(Math.hypot(one.x - other.x, one.y - other.y), 1);
  camera.shift((now.x - before.x) / 2, (now.y - before.y) / 2);
  camera.zoomAt(apart(now) / apart(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
}

/**
 * Return what keys do to a sheet, by their names.
 * @param {() => Camera} camera
 * @param {() => number} trueSize px a millimetre
 * @param {() => void} moved
 * @returns {Record<string, () => void>}
 */
export function keysOfSheet(camera, trueSize, moved) {
  const shift = (/** @type {number} */ across, /** @type {number} */ down) => () => {
    const { width, height } = camera().window;
    camera().shift(ARROW * across * width, ARROW * down * height);
    moved();
  };
  const zoom = (/** @type {() => number} */ factor) => () => {
    const { width, height } = camera().window;
    camera().zoomAt(factor(), width / 2, height / 2);
    moved();
  };
  return {
    ArrowLeft: shift(1, 0),
    ArrowRight: shift(-1, 0),
    ArrowUp: shift(0, 1),
    ArrowDown: shift(0, -1),
    "+": zoom(() => STEP),
    "=": zoom(() => STEP),
    "-": zoom(() => 1 / STEP),
    1: zoom(() => trueSize() / camera().zoom),
    0: () => {
      camera().showWhole();
      moved();
    },
  };
}
