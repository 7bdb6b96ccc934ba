import { element } from "./dom.js";
import { Camera } from "./pan.js";

/** No canvas has more points than this: telephones have little memory. */
const MOST_POINTS = 9e6;

/** A canvas that fills an element, on which paper lies; what it shows follows its camera, at most once a frame. */
export class Surface {
  /** @param {HTMLElement} surface what the canvas fills */
  constructor(surface) {
    this.surface = surface;
    this.canvas = /** @type {HTMLCanvasElement} */ (element("canvas", {}));
    this.context = contextOf(this.canvas);
    this.camera = new Camera(1, 1);
    this.frame = 0;
    surface.append(this.canvas);
    new ResizeObserver(() => this.measure()).observe(surface);
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.moved());
    new MutationObserver(() => this.moved()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
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

  /** Draw what is seen: between the paper and what stands on the screen's own points. */
  draw() {
    this.frame = 0;
    const { canvas, context, camera } = this;
    const { width, height } = camera.window;
    const ratio = Math.min(devicePixelRatio, Math.sqrt(MOST_POINTS / (width * height)));
    const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== across) canvas.width = across;
    if (canvas.height !== down) canvas.height = down;
    const style = getComputedStyle(this.surface);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = style.backgroundColor;
    context.fillRect(0, 0, width, height);
    const paper = this.paper();
    if (paper === null) return;
    const scale = ratio * camera.zoom;
    context.setTransform(scale, 0, 0, scale, -scale * camera.x, -scale * camera.y);
    context.fillStyle = "#fff";
    context.fillRect(0, 0, paper.width, paper.height);
    this.paint(style, scale);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.sign();
    this.surface.dataset["seen"] = [camera.x, camera.y, camera.zoom].join(" ");
  }

  /**
   * Return how large the paper is, in its own units; null: there is none.
   * @returns {{width: number, height: number} | null}
   */
  paper() {
    return null;
  }

  /**
   * Draw what lies on the paper, in its units.
   * @param {CSSStyleDeclaration} _style of the surface
   * @param {number} _scale points of the canvas to a unit
   */
  paint(_style, _scale) {}

  /** Draw what stands over it, in pixels. */
  sign() {}
}

/**
 * Return a canvas's context without see-through points: what is under it need not be blended in.
 * @param {HTMLElement} canvas
 */
export function contextOf(canvas) {
  const found = /** @type {HTMLCanvasElement} */ (canvas).getContext("2d", { alpha: false });
  return /** @type {CanvasRenderingContext2D} */ (found);
}
