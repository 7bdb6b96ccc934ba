import { drawnElement, element } from "../dom.js";
import { cornerFor, dragged, heldIn, LOUPE, nudged } from "./aim.js";
import { mmText } from "./figures.js";
import { markInk, lettersOf, rulerOf } from "./ink.js";
import { meantAt } from "./shapes.js";

/**
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./figures.js").Frame} Frame
 * @typedef {import("./shapes.js").Shape} Shape
 * @typedef {{zero: Spot, along: Spot, from: number, to: number, read: Spot | null}} Ruler a ruler on the board; what is
 *   read on it
 * @typedef {{frame: Frame, shapes: Shape[], letterOf: (slot: number) => string, arrows: boolean, picks: number[],
 *   fits: (slot: number) => boolean, now: number, wrong: (slot: number) => boolean, aim: Spot | null, moved: boolean,
 *   ruler: Ruler | null, taken: [number, number]}} Shown `moved`: whether the cross was moved since it is there
 */

const INK = "practice-ink";
/** How near a pointer has to come, px: a mouse, a finger. */
const POINTED = { mouse: 14, touch: 26 };

/** The board on which a student draws: ink, what is picked, the cross and its loupe. */
export class Paper {
  /**
   * @param {string} name
   * @param {string} told what the loupe is called
   * @param {(slots: number[], at: [number, number]) => void} onMeant what may be meant where one pointed, px of the paper
   * @param {(spot: Spot) => void} onAim
   */
  constructor(name, told, onMeant, onAim) {
    this.onMeant = onMeant;
    this.onAim = onAim;
    this.ink = drawnElement("g", { id: INK, class: "pencil" });
    this.letters = drawnElement("g", { class: "letters" });
    this.cross = drawnElement("g", { class: "cross" });
    this.svg = drawnElement("svg", { class: "sketch", role: "img", "aria-label": name }, this.ink, this.letters, this.cross);
    this.glass = drawnElement("svg", { class: "loupe", "aria-hidden": "true" });
    this.glass.append(drawnElement("use", { href: `#${INK}` }), drawnElement("g", { class: "cross" }));
    const title = drawnElement("title");
    title.textContent = told;
    this.glass.prepend(title);
    this.whole = element("div", { class: "paper", tabindex: "0", role: "group", "aria-label": name }, this.svg, this.glass);
    /** @type {Shown | null} */
    this.shown = null;
    this.mm = 1;
    this.listen();
    new ResizeObserver(() => this.draw()).observe(this.svg);
  }

  /** @param {Shown} shown */
  show(shown) {
    this.shown = shown;
    this.draw();
  }

  draw() {
    const shown = this.shown;
    const { width, height } = this.svg.getBoundingClientRect();
    if (shown === null || width === 0 || height === 0) return;
    const [left, low, right, high] = shown.frame;
    this.mm = Math.max((right - left) / width, (high - low) / height);
    this.svg.setAttribute("viewBox", [left, -high, right - left, high - low].map(mmText).join(" "));
    this.svg.style.setProperty("--mm", `${this.mm}px`);
    const ruler = shown.ruler;
    const laid = ruler === null ? [] : rulerOf(ruler.zero, ruler.along, ruler.from, ruler.to, this.mm);
    const drawn = shown.shapes.map((shape) => markInk(shape, this.mm, shown.arrows).map((part) => this.dressed(part, shape)));
    this.ink.replaceChildren(...drawn.flat(), ...laid);
    this.letters.replaceChildren(...lettersOf(shown.shapes, shown.letterOf, this.mm));
    this.whole.classList.toggle("aiming", shown.aim !== null);
    this.enlarge(shown.aim, shown.aim === null ? (ruler?.read ?? null) : shown.moved ? shown.aim : null);
  }

  /**
   * @param {SVGElement} part
   * @param {Shape} shape
   */
  dressed(part, shape) {
    const shown = /** @type {Shown} */ (this.shown);
    part.classList.toggle("picked", shown.picks.includes(shape.slot));
    part.classList.toggle("fits", shown.fits(shape.slot));
    part.classList.toggle("now", shape.of === shown.now);
    part.classList.toggle("wrong", shown.wrong(shape.of));
    return part;
  }

  /**
   * Show the cross, and what is beside a place in the loupe.
   * @param {Spot | null} aim
   * @param {Spot | null} seen
   */
  enlarge(aim, seen) {
    this.cross.replaceChildren(...(aim === null ? [] : crossAt(aim, this.mm)));
    this.glass.toggleAttribute("hidden", seen === null);
    if (seen === null || this.shown === null) return;
    const mm = this.mm / LOUPE;
    const side = this.glass.getBoundingClientRect().width * mm;
    this.glass.setAttribute("viewBox", [seen[0] - side / 2, -seen[1] - side / 2, side, side].map(mmText).join(" "));
    this.glass.style.setProperty("--mm", `${mm}px`);
    this.glass.lastElementChild?.replaceChildren(...(aim === null ? [] : crossAt(aim, mm)));
    const [right, low] = cornerFor(seen, this.shown.frame, this.shown.taken);
    this.glass.classList.toggle("right", right === 1);
    this.glass.classList.toggle("low", low === 1);
  }

  /**
   * Return the place of the board under a pointer.
   * @param {{clientX: number, clientY: number}} event
   * @returns {Spot}
   */
  spotUnder({ clientX, clientY }) {
    const to = /** @type {SVGSVGElement} */ (this.svg).getScreenCTM();
    if (to === null) return [0, 0];
    const at = new DOMPoint(clientX, clientY).matrixTransform(to.inverse());
    return [at.x, -at.y];
  }

  listen() {
    let held = false;
    this.svg.addEventListener("pointerdown", (event) => {
      if (this.shown?.aim === null || !event.isPrimary) return;
      held = true;
      this.svg.setPointerCapture(event.pointerId);
      this.aimAt(this.spotUnder(event));
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (held) this.aimAt(this.spotUnder(event));
      else this.point(event);
    });
    for (const name of ["pointerup", "pointercancel"]) this.svg.addEventListener(name, () => (held = false));
    this.svg.addEventListener("pointerleave", () => this.light([]));
    this.svg.addEventListener("click", (event) => this.meant(event));
    this.whole.addEventListener("keydown", (event) => {
      const { aim, frame } = this.shown ?? { aim: null, frame: null };
      if (event.target !== this.whole || !aim || !frame || event.ctrlKey || event.altKey || event.metaKey) return;
      const to = nudged(aim, event.key, event.shiftKey, frame);
      if (to === null) return;
      event.preventDefault();
      this.onAim(to);
    });
    this.listenToLoupe();
  }

  /** The loupe is dragged, so that a place is found more finely than a finger or a mouse can point. */
  listenToLoupe() {
    /** @type {Spot | null} */
    let last = null;
    this.glass.addEventListener("pointerdown", (event) => {
      last = this.spotUnder(event);
      this.glass.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    this.glass.addEventListener("pointermove", (event) => {
      const { aim, frame } = this.shown ?? {};
      if (last === null || !aim || !frame) return;
      const now = this.spotUnder(event);
      this.onAim(dragged(aim, [now[0] - last[0], now[1] - last[1]], frame));
      last = now;
    });
    for (const name of ["pointerup", "pointercancel"]) this.glass.addEventListener(name, () => (last = null));
  }

  /** @param {Spot} spot */
  aimAt(spot) {
    if (this.shown !== null) this.onAim(heldIn(spot, this.shown.frame));
  }

  /**
   * @param {PointerEvent | MouseEvent} event
   * @returns {number[]}
   */
  under(event) {
    const shown = this.shown;
    if (shown === null || shown.aim !== null) return [];
    const touch = "pointerType" in event && event.pointerType === "touch";
    const fits = (/** @type {number} */ slot) => shown.fits(slot) || shown.picks.includes(slot);
    return meantAt(shown.shapes, this.spotUnder(event), this.mm * (touch ? POINTED.touch : POINTED.mouse), fits);
  }

  /** @param {PointerEvent} event */
  point(event) {
    if (event.pointerType === "mouse") this.light(this.under(event));
  }

  /** @param {MouseEvent} event */
  meant(event) {
    const slots = this.under(event);
    const { left, top } = this.whole.getBoundingClientRect();
    if (this.shown?.aim === null) this.onMeant(slots, [event.clientX - left, event.clientY - top]);
  }

  /** @param {number[]} slots */
  light(slots) {
    this.svg.classList.toggle("over", slots.length > 0);
    const shapes = this.shown?.shapes ?? [];
    const wanted = new Set(shapes.filter((shape) => slots.includes(shape.slot)).map((shape) => String(shape.of)));
    for (const part of this.ink.children) part.classList.toggle("lit", wanted.has(part.getAttribute("data-of") ?? ""));
  }
}

/**
 * @param {Spot} spot
 * @param {number} mm of the board, a pixel of the screen
 */
function crossAt([x, y], mm) {
  const [near, far] = [4 * mm, 22 * mm];
  const arms = [[1, 0], [-1, 0], [0, 1], [0, -1]].map(
    ([p = 0, q = 0]) => `M${mmText(x + p * near)} ${mmText(-y + q * near)}L${mmText(x + p * far)} ${mmText(-y + q * far)}`,
  );
  return [drawnElement("path", { d: arms.join("") })];
}
