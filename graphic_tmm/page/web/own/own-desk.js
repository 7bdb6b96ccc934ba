import { element } from "../dom.js";
import { Camera } from "../pan.js";
import { contextOn } from "./photo.js";

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

/** No canvas has more points than this. */
const MOST_POINTS_OF_CANVAS = 9e6;
/** How large a sign is, and its lettering, px. */
const SIGN_SIZE = 7;
const SIGN_LETTERING = "600 14px system-ui, sans-serif";
/** A drawing over a photograph is so wide at least, px. */
const LEAST_LINE = 1.2;

/** The canvas of a photograph: what lies on it, drawn at most once a frame. */
export class OwnDesk {
  /** @param {HTMLElement} surface what it fills */
  constructor(surface) {
    this.surface = surface;
    this.canvas = /** @type {HTMLCanvasElement} */ (element("canvas", {}));
    this.context = contextOn(this.canvas);
    this.camera = new Camera(1, 1);
    /** @type {Laid | null} */
    this.laid = null;
    /** @type {Upon | null} */
    this.upon = null;
    /** @type {Sign[]} */
    this.signs = [];
    this.frame = 0;
    surface.append(this.canvas);
    new ResizeObserver(() => this.measure()).observe(surface);
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.moved());
    new MutationObserver(() => this.moved()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
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

  /** Take the size that the surface has now. */
  measure() {
    const { clientWidth, clientHeight } = this.surface;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.camera.resize(clientWidth, clientHeight);
    this.moved();
  }

  /** What is seen has changed. */
  moved() {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.frame = 0;
    const { canvas, context, camera, laid } = this;
    const { width, height } = camera.window;
    const ratio = Math.min(devicePixelRatio, Math.sqrt(MOST_POINTS_OF_CANVAS / (width * height)));
    const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== across) canvas.width = across;
    if (canvas.height !== down) canvas.height = down;
    const style = getComputedStyle(this.surface);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = style.backgroundColor;
    context.fillRect(0, 0, width, height);
    if (laid === null) return;
    const scale = ratio * camera.zoom;
    context.setTransform(scale, 0, 0, scale, -scale * camera.x, -scale * camera.y);
    context.fillStyle = "#fff";
    context.fillRect(0, 0, laid.width, laid.height);
    laid.picture.paint(context, laid.width, laid.height, (scale * laid.width) / laid.picture.width);
    if (this.upon !== null) this.over(this.upon, style.getPropertyValue("--over"));
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    for (const sign of this.signs) this.put(sign);
    this.surface.dataset["seen"] = [camera.x, camera.y, camera.zoom].join(" ");
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
