/**
 * Pointers and fingers on the paper: one draws, two move and zoom, the right button moves, the wheel zooms.
 *
 * @typedef {import("./paper.js").Paper} Paper
 * @typedef {import("./view.js").Dots} Dots
 */

/** A pointer that has moved so far draws, dots; less is a click. */
export const DRAWS = 6;
const WHEEL = 400;

/** @param {Paper} paper */
export function listenToPointers(paper) {
  const { svg } = paper;
  const pointers = new Pointers(paper);
  svg.addEventListener("pointerdown", (event) => pointers.pressed(event));
  svg.addEventListener("pointermove", (event) => pointers.moved(event));
  svg.addEventListener("pointerup", (event) => pointers.lifted(event));
  svg.addEventListener("pointercancel", (event) => pointers.lost(event));
  svg.addEventListener("wheel", (event) => pointers.wheel(event), { passive: false });
  svg.addEventListener("contextmenu", (event) => event.preventDefault());
}

class Pointers {
  /** @param {Paper} paper */
  constructor(paper) {
    this.paper = paper;
    /** @type {Map<number, Dots>} */
    this.fingers = new Map();
    /** @type {{at: Dots, moved: boolean} | null} */
    this.down = null;
    this.panning = false;
  }

  /** @param {PointerEvent} event */
  pressed(event) {
    if (this.paper.sketch === null) return;
    const at = this.paper.spot(event);
    this.fingers.set(event.pointerId, at);
    this.paper.svg.setPointerCapture(event.pointerId);
    this.paper.cross = null;
    if (event.button > 0 || this.fingers.size > 1) {
      if (this.down !== null) this.paper.hand.cancel();
      this.down = null;
      this.panning = true;
      return;
    }
    this.down = { at, moved: false };
    this.paper.hand.press(this.paper.meant(at, event.pointerType === "touch"));
  }

  /** @param {PointerEvent} event */
  moved(event) {
    if (this.paper.sketch === null) return;
    const at = this.paper.spot(event);
    const before = this.fingers.get(event.pointerId);
    if (this.panning && before !== undefined) {
      this.pinch(event.pointerId, before, at);
      return;
    }
    if (before !== undefined) this.fingers.set(event.pointerId, at);
    if (this.down !== null && Math.hypot(at[0] - this.down.at[0], at[1] - this.down.at[1]) > DRAWS) this.down.moved = true;
    if (this.down === null || this.down.moved) this.paper.hand.hover(this.paper.meant(at, event.pointerType === "touch"));
  }

  /**
   * Move the paper by one pointer; move and zoom it by two.
   * @param {number} id
   * @param {Dots} before
   * @param {Dots} at
   */
  pinch(id, before, at) {
    const other = [...this.fingers].find(([one]) => one !== id)?.[1];
    this.fingers.set(id, at);
    if (other === undefined) {
      this.paper.view.pan(at[0] - before[0], at[1] - before[1]);
    } else {
      const was = Math.hypot(before[0] - other[0], before[1] - other[1]);
      const is = Math.hypot(at[0] - other[0], at[1] - other[1]);
      this.paper.view.pan((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
      if (was > 0) this.paper.view.zoom(is / was, [(at[0] + other[0]) / 2, (at[1] + other[1]) / 2]);
    }
    this.paper.draw();
  }

  /** @param {PointerEvent} event */
  lifted(event) {
    this.fingers.delete(event.pointerId);
    if (this.fingers.size === 0) this.panning = false;
    const { down } = this;
    this.down = null;
    if (down === null || this.paper.sketch === null) return;
    this.paper.hand.release(this.paper.meant(down.moved ? this.paper.spot(event) : down.at, event.pointerType === "touch"), down.moved);
  }

  /** @param {PointerEvent} event */
  lost(event) {
    this.fingers.delete(event.pointerId);
    if (this.down !== null) this.paper.hand.cancel();
    this.down = null;
    this.panning = this.fingers.size > 0 && this.panning;
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    event.preventDefault();
    this.paper.view.zoom(Math.exp(-event.deltaY / WHEEL), this.paper.spot(event));
    this.paper.draw();
  }
}
