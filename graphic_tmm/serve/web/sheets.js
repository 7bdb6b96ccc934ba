import { element, filled, iconButton } from "../../page/web/dom.js";

/** @typedef {import("./types.js").Sheet} Sheet */
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

/** Pictures of sheets at their true shape, one below the other; a new one takes the place of the one before. */
export class Sheets {
  /** @param {Words} words */
  constructor(words) {
    this.words = words;
    /** @type {Sheet[]} */
    this.sheets = [];
    /** @type {HTMLElement[]} */
    this.figures = [];
    /** Pixels of the screen for a millimetre; 0: as many as show a sheet whole. */
    this.scale = 0;
    this.desk = element("div", { class: "desk", tabindex: "0", role: "region", "aria-label": words["desk"] ?? "" });
    this.nothing = element("p", { class: "hint" }, words["no sheets"] ?? "");
    this.desk.append(this.nothing);
    this.element = element("div", { class: "sheets" }, this.tools(), this.desk);
    this.desk.addEventListener("keydown", (event) => this.key(event));
    this.desk.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.desk.addEventListener("pointerdown", (event) => this.drag(event));
    new ResizeObserver(() => this.size()).observe(this.desk);
  }

  tools() {
    const acts = {
      larger: () => this.zoom(STEP),
      smaller: () => this.zoom(1 / STEP),
      whole: () => this.to(0),
      "true size": () => this.to(TRUE),
    };
    const buttons = Object.entries(acts).map(([name, act]) => {
      const made = iconButton(ICONS[name] ?? "", this.words[name] ?? "", act);
      made.querySelector("path")?.setAttribute("class", "line");
      return made;
    });
    return element("div", { class: "tools" }, ...buttons);
  }

  /**
   * Show sheets; those that stayed are not touched, nor is the place that is looked at.
   * @param {Sheet[]} sheets
   */
  show(sheets) {
    const sized = sheets.map((one) => `${one.width} ${one.height}`).join();
    const before = this.sheets.map((one) => `${one.width} ${one.height}`).join();
    const had = this.sheets;
    this.sheets = sheets;
    this.nothing.hidden = sheets.length > 0;
    while (this.figures.length > sheets.length) this.figures.pop()?.remove();
    sheets.forEach((sheet, k) => {
      const figure = this.figures[k] ?? this.figure();
      if (had[k]?.hash !== sheet.hash) this.picture(figure, sheet, k + 1);
    });
    if (sized !== before) this.size();
  }

  figure() {
    const made = element("figure", { class: "sheet" });
    this.figures.push(made);
    this.desk.append(made);
    return made;
  }

  /**
   * Put the picture of a sheet into its figure as soon as it is there; until then the one before stays.
   * @param {HTMLElement} figure
   * @param {Sheet} sheet
   * @param {number} n which it is
   */
  picture(figure, sheet, n) {
    const made = new Image();
    made.alt = filled(this.words["sheet"] ?? "", { n });
    made.draggable = false;
    figure.dataset["wanted"] = sheet.hash;
    made.addEventListener("load", () => {
      if (figure.dataset["wanted"] !== sheet.hash) return;
      figure.dataset["shown"] = sheet.hash;
      figure.replaceChildren(made);
    });
    made.src = `sheet/${sheet.hash}.svg`;
  }

  /** The pixels of the screen for a millimetre of a sheet. @param {Sheet} sheet */
  scaled(sheet) {
    if (this.scale > 0) return this.scale;
    const { clientWidth, clientHeight } = this.desk;
    return Math.max(LEAST, Math.min((clientWidth - ROOM) / sheet.width, (clientHeight - ROOM) / sheet.height));
  }

  /** Give every figure its size. */
  size() {
    this.sheets.forEach((sheet, k) => {
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
    const first = this.sheets[0];
    if (first === undefined) return;
    this.to(Math.min(MOST, Math.max(LEAST, this.scaled(first) * factor)), x, y);
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
