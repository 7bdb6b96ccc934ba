import * as acts from "./acts.js";
import { moved } from "./changes.js";
import { joined } from "./joining.js";
import { drivenBy, repeating } from "./roles.js";
import { apart, bodiesAt, frameOf, minus, placeOf } from "./sketch.js";
import { DEGREES } from "./snap.js";
import { targetOf, TOOL_ACTS } from "./tool-acts.js";
import { howOf } from "./tools.js";

/**
 * What presses and releases on the paper mean. A link is drawn from place to place; a chosen pin is moved; a tool
 * is for one act, and is laid down behind it.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./snap.js").Meant} Meant
 * @typedef {import("./editor.js").Editor} Editor
 * @typedef {"" | import("./tool-acts.js").ToolName} Tool
 */

export class Hand {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    /** @type {Tool} */
    this.tool = "";
    /** What was pressed, and whether a chosen pin is moved. @type {Meant | null} */
    this.begun = null;
    this.moving = "";
    /** The pin that a stone or a slider is for. */
    this.pin = "";
    this.free = false;
    window.addEventListener("keydown", (event) => (this.free = event.altKey));
    window.addEventListener("keyup", (event) => (this.free = event.altKey));
  }

  /** How what is pointed at is to be taken. */
  how() {
    const from = this.begun === null || this.moving !== "" ? undefined : this.begun.place;
    const aims = this.tool === "slider" && this.begun !== null;
    return { except: this.moving === "" ? undefined : this.moving, from, free: aims || this.free };
  }

  /**
   * Take a tool; what is chosen is what it is for, if that can be.
   * @param {Tool} tool
   */
  take(tool) {
    const { editor } = this;
    const { number, drawn } = editor.chosen;
    // a pin that a link was just drawn to is named by a letter, and not meant by a tool
    const letter = drawn ? undefined : editor.chosen.letter;
    this.cancel();
    // nor does it look as if it were
    if (drawn && tool !== "") editor.chosen = {};
    if (tool === "support" && letter !== undefined) editor.act(acts.supported(editor.sketch, letter), {});
    else if (tool === "drive" && number !== undefined) this.drive(number);
    else if (tool === "passive" && number !== undefined) editor.act(repeating(editor.sketch, number), {});
    else this.tool = tool;
    this.pin = letter ?? "";
    editor.changed();
    editor.tell(this.asks());
  }

  /** @param {number} number */
  drive(number) {
    const { sketch, numbers } = drivenBy(this.editor.sketch, number);
    this.editor.act(sketch, {}, { numbers });
  }

  cancel() {
    this.tool = "";
    this.begun = null;
    this.moving = "";
    this.pin = "";
    this.editor.paper.stretch({ from: null, to: null, says: "" });
    this.editor.changed();
  }

  /** @param {Meant} meant */
  press(meant) {
    if (this.editor.picture.corner(meant.place)) return;
    const { chosen } = this.editor;
    this.begun = meant;
    if (this.tool === "" && meant.letter !== undefined && meant.letter === chosen.letter && !chosen.drawn) this.moving = meant.letter;
    if (this.tool === "slider" && this.pin === "") this.pin = meant.letter ?? "";
  }

  /** @param {Meant} meant */
  hover(meant) {
    const { paper } = this.editor;
    const from = this.startOf();
    if (this.begun !== null && this.moving !== "") {
      const { sketch } = this.editor;
      const there = moved(sketch, this.moving, meant.place);
      paper.sketch = there;
      paper.draw();
      paper.stretch({ from: null, to: { ...meant, place: placeOf(there, this.moving) }, says: this.joins(meant) || this.lengths(there, this.moving) });
      return;
    }
    paper.stretch({ from, to: meant, says: this.says(meant, from) });
  }

  /** Where the line begins that is being drawn. */
  startOf() {
    if (this.begun === null || !["", "slider", "cylinder"].includes(this.tool)) return null;
    return this.tool === "slider" && this.pin !== "" ? placeOf(this.editor.sketch, this.pin) : this.begun.place;
  }

  /**
   * What is said beside the pointer: what will be joined, or how long it is.
   * @param {Meant} meant
   * @param {Place | null} from
   */
  says(meant, from) {
    if (this.tool === "slider" && from !== null) return `${this.angle(from, meant.place)}°`;
    const long = from === null ? 0 : Math.round(1000 * apart(from, meant.place));
    return [long > 0 ? `${long} ${this.editor.say("mm")}` : "", this.joins(meant)].filter(Boolean).join(" · ");
  }

  /**
   * What will be joined.
   * @param {Meant} meant
   */
  joins({ letter, bar }) {
    if (letter !== undefined) return this.editor.say("scheme joined", { letter });
    return bar === undefined ? "" : this.editor.say("scheme on link", { number: bar.number });
  }

  /**
   * The lengths from a pin that is moved to the others of its links, mm.
   * @param {Sketch} sketch
   * @param {string} letter
   */
  lengths(sketch, letter) {
    const others = bodiesAt(sketch, letter).flatMap((body) => (body === frameOf(sketch) ? [] : body.points.filter((one) => one !== letter && one !== body.centre)));
    return others.map((one) => `${one}${letter} ${Math.round(1000 * apart(placeOf(sketch, one), placeOf(sketch, letter)))}`).join(" · ");
  }

  /**
   * @param {Place} from
   * @param {Place} to
   */
  angle(from, to) {
    const [x, y] = minus(to, from);
    const degrees = (Math.atan2(y, x) * 180) / Math.PI;
    return this.free ? Math.round(10 * degrees) / 10 : DEGREES * Math.round(degrees / DEGREES);
  }

  /**
   * @param {Meant} meant
   * @param {boolean} drawn elsewhere than it was pressed
   */
  release(meant, drawn) {
    const { begun, tool, moving, pin } = this;
    if (begun === null) return;
    const from = this.startOf();
    this.begun = null;
    this.moving = "";
    this.editor.paper.stretch({ from: null, to: null, says: "" });
    const angle = from === null || (!drawn && apart(from, meant.place) === 0) ? 0 : this.angle(from, meant.place);
    if (tool !== "") this.use(tool, { begun, meant, drawn, angle, pin });
    else if (moving !== "") this.move(moving, drawn ? meant : null);
    else if (drawn) this.link(begun, meant);
    else this.choose(meant);
  }

  /**
   * Move a pin, onto another or a bar if it was dropped there; null: it stays chosen.
   * @param {string} letter
   * @param {Meant | null} meant
   */
  move(letter, meant) {
    const { editor } = this;
    if (meant === null) return editor.changed();
    if (meant.letter === undefined && meant.bar === undefined) return editor.act(moved(editor.sketch, letter, meant.place));
    const made = joined(editor.sketch, letter, targetOf(meant));
    if (made !== null) return editor.act(made, { letter: meant.letter ?? letter });
    editor.changed();
    editor.tell(this.apart(letter, meant.letter ?? ""));
  }

  /**
   * Why two pins cannot become one.
   * @param {string} a
   * @param {string} b
   */
  apart(a, b) {
    const { sketch } = this.editor;
    const body = bodiesAt(sketch, a).find((one) => one.points.includes(b));
    const link = body === undefined || body === frameOf(sketch) ? this.editor.say("scheme frame") : body.number;
    return this.editor.say("scheme both on", { a, b, link });
  }

  /** @param {Meant} meant */
  choose(meant) {
    const { editor } = this;
    if (meant.letter !== undefined) editor.choose({ letter: meant.letter });
    else editor.choose(meant.bar === undefined ? {} : { number: meant.bar.number });
  }

  /**
   * @param {Meant} start
   * @param {Meant} end
   */
  link(start, end) {
    const { editor } = this;
    const made = acts.linked(editor.sketch, targetOf(start), targetOf(end));
    if (made === null) editor.tell(editor.say("scheme same link"));
    else editor.act(made.sketch, { letter: made.letter, drawn: true });
  }

  /**
   * Use a tool, and lay it down; it stays where it has not done anything yet.
   * @param {import("./tool-acts.js").ToolName} tool
   * @param {import("./tool-acts.js").Use} use
   */
  use(tool, use) {
    const { editor } = this;
    const done = TOOL_ACTS[tool](editor, use) ?? {};
    if ("sketch" in done) {
      this.tool = "";
      this.pin = "";
      editor.act(done.sketch, done.letter === undefined ? {} : { letter: done.letter, drawn: true }, { numbers: done.numbers ?? {} });
    } else {
      this.pin = done.wait ?? use.pin;
      if (done.link !== undefined) editor.chosen = { number: done.link };
      editor.tell(this.asks());
    }
    editor.changed();
  }

  /** What a tool that is taken asks for; "" without one. */
  asks() {
    const { number } = this.editor.chosen;
    if (this.tool === "point" && number !== undefined) return this.editor.say("scheme point place", { number });
    if (this.tool === "weld" && number !== undefined) return this.editor.say("scheme weld with", { number });
    return this.tool === "" ? "" : this.editor.say(this.tool === "stone" && this.pin !== "" ? "scheme stone bar" : howOf(this.tool));
  }
}
