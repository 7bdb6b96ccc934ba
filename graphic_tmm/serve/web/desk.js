import { element, iconButton } from "../../page/web/dom.js";

/** @typedef {import("./types.js").Words} Words */

/** Pixels of a screen for a millimetre, as style sheets count them. */
const TRUE = 96 / 25.4;
const STEP = 1.25;
const LEAST = 0.1;
const MOST = 40;
/** What is left free about a sheet that is shown whole, px. */
const ROOM = 16;
/** @type {Record<string, string>} */
const ICONS = {
  larger: "M5 12h14M12 5v14",
  smaller: "M5 12h14",
  whole: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
  "true size": "M7 8l2-1v10M15 8l2-1v10M12.5 10v.5M12.5 14v.5",
};

/** What is shown at its true shape, one below the other, larger or smaller; sizes are millimetres, or dots. */
export class ZoomDesk {
  /**
   * @param {Words} words
   * @param {string} label what it is and what its keys do
   * @param {string[]} tools by the names of their words
   */
  constructor(words, label, tools) {
    this.words = words;
    /** @type {{width: number, height: number}[]} */
    this.sizes = [];
    /** @type {HTMLElement[]} */
    this.figures = [];
    /** Pixels of the screen for a millimetre; 0: as many as show a sheet whole. */
    this.scale = 0;
    this.least = LEAST;
    this.desk = element("div", { class: "desk", tabindex: "0", role: "region", "aria-label": label });
    this.tools = this.buttons(tools);
    this.desk.addEventListener("keydown", (event) => this.key(event));
    this.desk.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.desk.addEventListener("pointerdown", (event) => this.drag(event));
    new ResizeObserver(() => this.size()).observe(this.desk);
  }

  /** @param {string[]} names */
  buttons(names) {
    /** @type {Record<string, () => void>} */
    const acts = {
      larger: () => this.zoom(STEP),
      smaller: () => this.zoom(1 / STEP),
      whole: () => this.to(0),
      "true size": () => this.to(TRUE),
    };
    const buttons = names.map((name) => {
      const made = iconButton(ICONS[name] ?? "", this.words[name] ?? "", acts[name] ?? (() => {}));
      made.querySelector("path")?.setAttribute("class", "line");
      return made;
    });
    return element("div", { class: "tools" }, ...buttons);
  }

  figure() {
    const made = element("figure", { class: "sheet" });
    this.figures.push(made);
    this.desk.append(made);
    return made;
  }

  /** The pixels of the screen for a millimetre of a sheet. @param {{width: number, height: number}} sheet */
  scaled(sheet) {
    if (this.scale > 0) return this.scale;
    const { clientWidth, clientHeight } = this.desk;
    return Math.max(this.least, Math.min((clientWidth - ROOM) / sheet.width, (clientHeight - ROOM) / sheet.height));
  }

  /** Give every figure its size. */
  size() {
    this.sizes.forEach((sheet, k) => {
      const figure = this.figures[k];
      const scale = this.scaled(sheet);
      if (figure === undefined) return;
      figure.style.width = `${sheet.width * scale}px`;
      figure.style.height = `${sheet.height * scale}px`;
    });
  }

  /**
   * Show sheets larger or smaller.
   * @param {number} factor
   * @param {number} x of the place that stays, from the left of the desk, px
   * @param {number} y
   */
  zoom(factor, x = this.desk.clientWidth / 2, y = this.desk.clientHeight / 2) {
    const first = this.sizes[0];
    if (first === undefined) return;
    this.to(Math.min(MOST, Math.max(this.least, this.scaled(first) * factor)), x, y);
  }

  /**
   * Show sheets at a scale, 0 for whole; the place under a point of the desk stays there.
   * @param {number} scale
   * @param {number} x
   * @param {number} y
   */
  to(scale, x = this.desk.clientWidth / 2, y = this.desk.clientHeight / 2) {
    const desk = this.desk.getBoundingClientRect();
    const at = (/** @type {HTMLElement} */ one) => one.getBoundingClientRect();
    const held = this.figures.find((one) => at(one).bottom - desk.top >= y) ?? this.figures.at(-1);
    if (held === undefined) return;
    const before = at(held);
    const across = (desk.left + x - before.left) / before.width;
    const down = (desk.top + y - before.top) / before.height;
    this.scale = scale;
    this.size();
    const now = at(held);
    this.desk.scrollLeft += now.left + across * now.width - desk.left - x;
    this.desk.scrollTop += now.top + down * now.height - desk.top - y;
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "+" || event.key === "=") this.zoom(STEP);
    else if (event.key === "-") this.zoom(1 / STEP);
    else if (event.key === "0") this.to(0);
    else if (event.key === "1") this.to(TRUE);
    else return;
    event.preventDefault();
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const desk = this.desk.getBoundingClientRect();
    this.zoom(Math.exp(-event.deltaY / 300), event.clientX - desk.left, event.clientY - desk.top);
  }

  /**
   * Move the sheets with the mouse; fingers move them by themselves.
   * @param {PointerEvent} event
   */
  drag(event) {
    if (event.pointerType !== "mouse" || event.button !== 0) return;
    this.desk.setPointerCapture(event.pointerId);
    const move = (/** @type {PointerEvent} */ moved) => {
      this.desk.scrollLeft -= moved.movementX;
      this.desk.scrollTop -= moved.movementY;
    };
    this.desk.addEventListener("pointermove", move);
    this.desk.addEventListener("lostpointercapture", () => this.desk.removeEventListener("pointermove", move), {
      once: true,
    });
  }
}
