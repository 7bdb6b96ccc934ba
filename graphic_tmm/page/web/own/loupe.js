import { element } from "../dom.js";
import { canvasOf, contextOn } from "./photo.js";

/**
 * @typedef {import("./photo.js").Picture} Picture
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {[number, number, number, number]} Turn what steps across and down the loupe are in the photograph, px of
 *   it a dot of the loupe: x and y of a step across, x and y of a step down
 */

/** So many times larger than the photograph the loupe shows. */
export const MAGNIFIED = 4;
/** Its side, CSS px. */
const SIDE = 232;
/** The cross leaves so much free about its middle, and is so long, px. */
const FREE = 6;
const ARM = 40;
/** A pointer that moved less has pressed, px. */
const PRESSED_WITHIN = 4;

/**
 * Return the turn under which the sheet stands upright in the loupe, or the photograph as it is.
 * @param {number[]} steps what a millimetre across and one up are in the photograph: Shot.stepsAt
 * @returns {Turn}
 */
export function uprightTurn([ax = 1, ay = 0, bx = 0, by = -1]) {
  const size = MAGNIFIED * Math.sqrt(Math.abs(ax * by - ay * bx));
  return [ax / size, ay / size, -bx / size, -by / size];
}

/** The turn of a photograph as it is. @type {Turn} */
export const AS_IT_IS = [1 / MAGNIFIED, 0, 0, 1 / MAGNIFIED];

/** A loupe over a photograph: what is about a place, four times as large; a drag or a press in it moves the place. */
export class Loupe {
  /**
   * @param {string} name
   * @param {(spot: Spot) => void} moved
   */
  constructor(name, moved) {
    this.canvas = canvasOf(SIDE, SIDE);
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", name);
    this.root = element("div", { class: "own-loupe" }, this.canvas);
    this.root.hidden = true;
    this.moved = moved;
    /** @type {Picture | null} */
    this.picture = null;
    /** @type {Spot} */
    this.spot = [0, 0];
    this.turn = AS_IT_IS;
    this.listen();
  }

  /**
   * Show what is about a place.
   * @param {Picture} picture
   * @param {Spot} spot px of the photograph, the centre of its first dot is 0
   * @param {Turn} turn
   */
  show(picture, spot, turn) {
    this.picture = picture;
    this.spot = spot;
    this.turn = turn;
    this.root.hidden = false;
    this.root.dataset["at"] = [...spot, ...turn].join(" ");
    this.draw();
  }

  /**
   * Return the place so many dots of the loupe across and down from its middle, px of the photograph.
   * @param {number} across
   * @param {number} down
   * @returns {Spot}
   */
  beside(across, down) {
    const [ax, ay, bx, by] = this.turn;
    return [this.spot[0] + ax * across + bx * down, this.spot[1] + ay * across + by * down];
  }

  draw() {
    if (this.picture === null) return;
    const ratio = Math.min(devicePixelRatio, 3);
    const side = Math.round((this.canvas.clientWidth || SIDE) * ratio);
    if (this.canvas.width !== side) this.canvas.width = this.canvas.height = side;
    const context = contextOn(this.canvas);
    const style = getComputedStyle(this.root);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = style.backgroundColor;
    context.fillRect(0, 0, side, side);
    const [ax, ay, bx, by] = this.turn;
    const whole = ax * by - ay * bx;
    const turned = [by / whole, -ay / whole, -bx / whole, ax / whole].map((one) => one * ratio);
    const [a = 1, b = 0, c = 0, d = 1] = turned;
    // what is drawn of the photograph: the square about the place that the loupe can show at any turn
    const reach = Math.ceil((SIDE / MAGNIFIED) * 0.75);
    const left = Math.max(Math.floor(this.spot[0]) - reach, 0);
    const top = Math.max(Math.floor(this.spot[1]) - reach, 0);
    const wide = Math.min(2 * reach, this.picture.width - left);
    const high = Math.min(2 * reach, this.picture.height - top);
    context.setTransform(a, b, c, d, side / 2, side / 2);
    const [x, y] = [left - 0.5 - this.spot[0], top - 0.5 - this.spot[1]];
    if (wide > 0 && high > 0) context.drawImage(this.picture.source, left, top, wide, high, x, y, wide, high);
    context.setTransform(ratio, 0, 0, ratio, side / 2, side / 2);
    this.cross(context, "#fff", 3);
    this.cross(context, "#b8003a", 1);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {string} colour
   * @param {number} width
   */
  cross(context, colour, width) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    for (const [dx, dy] of /** @type {Spot[]} */ ([
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ])) {
      context.moveTo(dx * FREE, dy * FREE);
      context.lineTo(dx * ARM, dy * ARM);
    }
    context.stroke();
  }

  listen() {
    /** @type {Spot | null} */
    let last = null;
    let way = 0;
    this.canvas.addEventListener("pointerdown", (event) => {
      last = [event.clientX, event.clientY];
      way = 0;
      this.canvas.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (last === null) return;
      const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
      way += Math.hypot(dx, dy);
      last = [event.clientX, event.clientY];
      if (way > PRESSED_WITHIN) this.moved(this.beside(-dx, -dy));
    });
    this.canvas.addEventListener("pointerup", (event) => {
      const box = this.canvas.getBoundingClientRect();
      const [dx, dy] = [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
      if (last !== null && way <= PRESSED_WITHIN) this.moved(this.beside(dx, dy));
      last = null;
    });
  }
}
