import { listenToKeys } from "../keys.js";
import { keysOfSheet, listenToHands } from "../sheet-gestures.js";
import { AS_IT_IS, Loupe, uprightTurn } from "./loupe.js";

/**
 * @typedef {import("../state.js").State} State
 * @typedef {import("./own-desk.js").OwnDesk} OwnDesk
 * @typedef {import("./photo.js").Picture} Picture
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {import("./shot.js").Shot} Shot
 * Through what one looks at the desk: the photograph, and, where the sheet lies flat there, how it shows the sheet,
 * and the upper left corner of what is seen of it, mm
 * @typedef {{picture: Picture, shot: Shot | null, left: number, top: number}} Sight
 */

/** Nudges that follow each other within this time are held, ms; then each is farther, up to so many dots of the loupe. */
const HELD = 160;
const FARTHEST = 160;
const GROWS = 1.15;

/** The place that is aimed at, px of the photograph: by a tap, by the loupe, by arrows. */
export class Aim {
  /**
   * @param {State} state
   * @param {string} tab
   * @param {OwnDesk} desk
   * @param {string} name of the loupe
   */
  constructor(state, tab, desk, name) {
    this.desk = desk;
    /** @type {Sight | null} */
    this.sight = null;
    /** @type {Spot | null} */
    this.spot = null;
    /** Whether a place is shown in the loupe, and waits to be taken. */
    this.fine = true;
    this.step = 1;
    this.nudged = 0;
    this.onAim = () => {};
    this.onTake = () => {};
    this.loupe = new Loupe(name, (spot) => this.at(spot));
    const camera = () => desk.camera;
    const moved = () => desk.moved();
    listenToHands(desk.surface, camera, moved, (px, py) => this.tap(px, py));
    const keys = keysOfSheet(camera, () => desk.camera.fitting, moved);
    const { "+": larger, "=": same, "-": smaller, 0: whole } = keys;
    listenToKeys(state, tab, {
      ...Object.fromEntries(Object.entries({ "+": larger, "=": same, "-": smaller, 0: whole }).map(([key, act]) => [key, act ?? moved])),
      ArrowLeft: () => this.nudge(-1, 0),
      ArrowRight: () => this.nudge(1, 0),
      ArrowUp: () => this.nudge(0, -1),
      ArrowDown: () => this.nudge(0, 1),
      Enter: () => this.take(),
    });
  }

  /**
   * Look at the desk through another sight; nothing is aimed at.
   * @param {Sight | null} sight
   * @param {boolean} fine
   */
  through(sight, fine) {
    this.sight = sight;
    this.fine = fine;
    this.clear();
  }

  clear() {
    this.spot = null;
    this.loupe.root.hidden = true;
  }

  /**
   * Return which place of the photograph lies at a place of the desk.
   * @param {Spot} spot
   * @returns {Spot}
   */
  inPhoto([x, y]) {
    const { shot = null, left = 0, top = 0 } = this.sight ?? {};
    return shot === null ? [x - 0.5, y - 0.5] : shot.seen(left + x, top - y);
  }

  /**
   * Return where a place of the photograph lies on the desk.
   * @param {Spot} spot
   * @returns {Spot}
   */
  onDesk([px, py]) {
    const { shot = null, left = 0, top = 0 } = this.sight ?? {};
    if (shot === null) return [px + 0.5, py + 0.5];
    const [x, y] = shot.onSheet(px, py);
    return [x - left, top - y];
  }

  /**
   * @param {number} px
   * @param {number} py
   */
  tap(px, py) {
    if (this.sight === null) return;
    this.at(this.inPhoto(this.desk.camera.onSheet(px, py)));
    if (!this.fine) this.take();
  }

  /**
   * Aim at a place of the photograph.
   * @param {Spot} spot
   */
  at(spot) {
    if (this.sight === null || !spot.every(Number.isFinite)) return;
    const { picture, shot } = this.sight;
    this.spot = [keptWithin(spot[0], picture.width), keptWithin(spot[1], picture.height)];
    const turn = shot === null ? AS_IT_IS : uprightTurn(shot.stepsAt(...shot.onSheet(...this.spot)));
    if (this.loupe.root.hidden) this.loupe.root.classList.toggle("aside", this.besideLoupe(this.spot));
    this.loupe.show(picture, this.spot, turn);
    this.onAim();
  }

  /**
   * Whether a place is in the right half of the desk, where the loupe usually is.
   * @param {Spot} spot
   */
  besideLoupe(spot) {
    const { camera } = this.desk;
    return camera.onScreen(...this.onDesk(spot))[0] > camera.window.width / 2;
  }

  /**
   * Move the aim by a dot of the loupe; held, farther and farther.
   * @param {number} across
   * @param {number} down
   */
  nudge(across, down) {
    if (this.sight === null) return;
    if (this.spot === null) {
      const { width, height } = this.desk.camera.window;
      return this.at(this.inPhoto(this.desk.camera.onSheet(width / 2, height / 2)));
    }
    const now = performance.now();
    this.step = now - this.nudged < HELD ? Math.min(this.step * GROWS, FARTHEST) : 1;
    this.nudged = now;
    const by = Math.floor(this.step);
    this.at(this.loupe.beside(across * by, down * by));
  }

  /** Take the place that is aimed at. */
  take() {
    if (this.spot !== null) this.onTake();
  }
}

/**
 * @param {number} x
 * @param {number} size
 */
function keptWithin(x, size) {
  return Math.min(Math.max(x, -0.5), size - 0.5);
}
