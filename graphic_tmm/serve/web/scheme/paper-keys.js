import { DRAWS } from "./pointers.js";
import { placeOf } from "./sketch.js";

/**
 * The keys on the paper: arrows move a cross, Enter presses and releases there.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./paper.js").Paper} Paper
 * @typedef {import("./view.js").Dots} Dots
 */

const ZOOM = 1.25;
/** So many squares the cross goes with Shift. */
const LEAP = 10;
/** The cross is kept so far inside the window, dots. */
const INSIDE = 40;
const ARROWS = /** @type {Record<string, Place>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] });

/** @param {Paper} paper */
export function listenToKeys(paper) {
  const keys = new Keys(paper);
  paper.svg.addEventListener("keydown", (event) => keys.key(event));
  paper.svg.addEventListener("blur", () => {
    paper.rest = paper.cross ?? paper.rest;
    keys.held = false;
    paper.cross = null;
    paper.draw();
  });
}

class Keys {
  /** @param {Paper} paper */
  constructor(paper) {
    this.paper = paper;
    /** Whether a key has pressed and not released yet, and where. */
    this.held = false;
    /** @type {Dots} */
    this.heldAt = [0, 0];
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    if ((plain && this.own(event)) || this.paper.hand.key(event)) event.preventDefault();
  }

  /**
   * @param {KeyboardEvent} event
   * @returns {boolean} whether it was for the paper itself
   */
  own({ key, shiftKey }) {
    const way = ARROWS[key];
    if (way !== undefined) this.step(way, shiftKey ? LEAP : 1);
    else if (key === "Enter") this.enter();
    else if (key === "+" || key === "=") this.paper.zoom(ZOOM);
    else if (key === "-") this.paper.zoom(1 / ZOOM);
    else if (key === "Escape") this.leave();
    else return false;
    return true;
  }

  leave() {
    this.held = false;
    this.paper.hand.cancel();
  }

  /**
   * Move the cross by squares; over what it stands on the way.
   * @param {Place} way
   * @param {number} squares
   */
  step([x, y], squares) {
    const { view } = this.paper;
    const by = view.square * squares;
    const [cx, cy] = this.paper.cross ?? this.beginning();
    const whole = (/** @type {number} */ one) => Math.round(one / view.square) * view.square;
    this.paper.cross = [whole(cx + x * by), whole(cy + y * by)];
    const [u, v] = view.dots(this.paper.cross);
    view.pan(inward(u, view.width), inward(v, view.height));
    this.paper.draw();
    this.paper.hand.hover(this.paper.meant(view.dots(this.paper.cross)));
  }

  /** Where the cross begins: where it was last, at the chosen pin, else in the middle. @returns {Place} */
  beginning() {
    const { letter } = this.paper.chosen;
    if (this.paper.rest !== null) return this.paper.rest;
    if (letter !== undefined && this.paper.sketch !== null) return placeOf(this.paper.sketch, letter);
    return this.paper.view.place([this.paper.view.width / 2, this.paper.view.height / 2]);
  }

  /** Press at the cross, or release there: elsewhere than pressed that draws. */
  enter() {
    if (this.paper.sketch === null) return;
    this.paper.cross ??= this.beginning();
    const spot = this.paper.view.dots(this.paper.cross);
    if (this.held) {
      this.held = false;
      const drawn = Math.hypot(spot[0] - this.heldAt[0], spot[1] - this.heldAt[1]) > DRAWS;
      this.paper.hand.release(this.paper.meant(spot), drawn);
    } else {
      this.held = true;
      this.heldAt = spot;
      this.paper.hand.press(this.paper.meant(spot));
      this.paper.hand.begun();
    }
    this.paper.drawOver();
  }
}

/**
 * Return how far the paper is to be moved for a spot to stand inside.
 * @param {number} at
 * @param {number} size
 */
function inward(at, size) {
  return Math.min(0, size - INSIDE - at) + Math.max(0, INSIDE - at);
}
