import { Camera } from "../pan.js";
import { Surface } from "../surface.js";

/**
 * @typedef {import("./photo.js").Picture} Picture
 * @typedef {import("./projection.js").Spot} Spot
 * What lies on the desk: a picture that fills a rectangle of the desk's own units (y downward)
 * @typedef {{picture: Picture, width: number, height: number}} Laid
 * A drawing over it: its lines, how it is moved and seen through
 * @typedef {{path: Path2D, x: number, y: number, opacity: number}} Upon
 * A place on it: what it is called, its sign
 * @typedef {{at: Spot, name: string, sign: "corner" | "fine" | "doubtful" | "wrong" | "origin" | "aim"}} Sign
 */

/** How large a sign is, and its lettering, px. */
const SIGN_SIZE = 7;
const SIGN_LETTERING = "600 14px system-ui, sans-serif";
/** A drawing over a photograph is so wide at least, px. */
const LEAST_LINE = 1.2;

/** The canvas of a photograph. */
export class OwnDesk extends Surface {
  /** @param {HTMLElement} surface what it fills */
  constructor(surface) {
    super(surface);
    /** @type {Laid | null} */
    this.laid = null;
    /** @type {Upon | null} */
    this.upon = null;
    /** @type {Sign[]} */
    this.signs = [];
  }

  /**
   * Lay a picture on the desk, all of it to be seen.
   * @param {Laid} laid
   */
  lay(laid) {
    this.laid = laid;
    this.camera = new Camera(laid.width, laid.height);
    this.measure();
  }

  paper() {
    return this.laid;
  }

  /**
   * @param {CSSStyleDeclaration} style
   * @param {number} scale
   */
  paint(style, scale) {
    if (this.laid === null) return;
    const { picture, width, height } = this.laid;
    picture.paint(this.context, width, height, (scale * width) / picture.width);
    if (this.upon !== null) this.over(this.upon, style.getPropertyValue("--over"));
  }

  sign() {
    for (const sign of this.signs) this.put(sign);
  }

  /**
   * @param {Upon} upon
   * @param {string} colour
   */
  over({ path, x, y, opacity }, colour) {
    const { context, camera } = this;
    context.save();
    context.translate(x, y);
    context.globalAlpha = opacity;
    context.strokeStyle = colour;
    context.lineWidth = Math.max(LEAST_LINE / camera.zoom, 0.15);
    context.stroke(path);
    context.restore();
  }

  /** @param {Sign} sign */
  put({ at, name, sign }) {
    const { context } = this;
    const [x, y] = this.camera.onScreen(...at);
    const lines = SIGN_LINES[sign];
    context.font = SIGN_LETTERING;
    context.lineJoin = "round";
    for (const [colour, width] of /** @type {[string, number][]} */ ([
      ["#fff", 5],
      [SIGN_COLOURS[sign], 2],
    ])) {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.beginPath();
      if (lines.length === 0) context.arc(x, y, SIGN_SIZE, 0, 2 * Math.PI);
      for (const [k, [dx, dy]] of lines.entries()) {
        const go = k === 0 || (sign !== "doubtful" && k % 2 === 0) ? "moveTo" : "lineTo";
        context[go](x + SIGN_SIZE * dx, y + SIGN_SIZE * dy);
      }
      context.stroke();
      if (width > 4) context.strokeText(name, x + SIGN_SIZE + 3, y - SIGN_SIZE);
    }
    context.fillStyle = SIGN_COLOURS[sign];
    context.fillText(name, x + SIGN_SIZE + 3, y - SIGN_SIZE);
  }
}

/** @type {[number, number][]} */
const CROSS_LINES = [
  [-1, -1],
  [1, 1],
  [-1, 1],
  [1, -1],
];
/** @type {[number, number][]} */
const PLUS_LINES = [
  [-1.4, 0],
  [1.4, 0],
  [0, -1.4],
  [0, 1.4],
];
/** Signs are told apart by their shape too: a ring if there are no lines. @type {Record<Sign["sign"], [number, number][]>} */
const SIGN_LINES = {
  fine: [],
  doubtful: [
    [0, -1.2],
    [1.1, 0.8],
    [-1.1, 0.8],
    [0, -1.2],
  ],
  wrong: CROSS_LINES,
  origin: PLUS_LINES,
  corner: PLUS_LINES,
  aim: PLUS_LINES,
};
/** On a photograph, light or dark, each with a white rim. @type {Record<Sign["sign"], string>} */
const SIGN_COLOURS = {
  fine: "#00664f",
  doubtful: "#8a5300",
  wrong: "#b8003a",
  origin: "#0050a8",
  corner: "#b8003a",
  aim: "#b8003a",
};
