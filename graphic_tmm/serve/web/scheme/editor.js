import { element } from "../../../page/web/dom.js";
import { rebased } from "./changes.js";
import { keyed } from "./editor-keys.js";
import { History } from "./history.js";
import { Hand } from "./hand.js";
import { Paper } from "./paper.js";
import { Picture } from "./picture.js";
import { lookAgain, seenBefore } from "./seen.js";
import { Side } from "./side.js";
import { blankSketch, bodyOf } from "./sketch.js";
import { ToolBar } from "./tools.js";
import { Turning } from "./turning.js";

/**
 * The scheme of a mechanism, drawn by a hand. The scene is what counts: every act goes to the server, and what is
 * shown then is where the log puts it.
 *
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./signs.js").Chosen} Chosen
 * @typedef {import("../types.js").Words} Words
 * @typedef {import("../types.js").SchemeAnswer} SchemeAnswer
 * @typedef {import("../types.js").SchemeAct} SchemeAct
 * @typedef {{sketch: Sketch, text: string, answer: SchemeAnswer | null, measured: boolean, origin: [number, number]}} Moment
 *   origin: where that of the paper at the beginning is, m
 */

/** So many acts can be taken back. */
const BACK = 200;

export class Editor {
  /**
   * @param {Words} words
   * @param {(act: SchemeAct) => Promise<import("../types.js").SchemeTold>} send
   * @param {(text: string) => void} tell
   * @param {boolean} fixed
   */
  constructor(words, send, tell, fixed = false) {
    this.words = words;
    this.send = send;
    this.tell = tell;
    this.fixed = fixed;
    /** @type {Sketch} */
    this.sketch = blankSketch();
    this.text = "";
    /** @type {SchemeAnswer | null} */
    this.answer = null;
    /** @type {Chosen} */
    this.chosen = {};
    /** @type {History<Moment>} */
    this.history = new History(BACK);
    /** Acts that are on their way, one after the other. @type {Promise<void>} */
    this.queue = Promise.resolve();
    this.waiting = 0;
    /** Acts of the hand that are shown, and not sent yet. */
    this.ahead = 0;
    /** Whether a length was typed: the first is the scale of all. */
    this.measured = false;
    /** @type {[number, number]} */
    this.origin = [0, 0];
    this.typedAt = 0;
    /** Whoever shall know that something has changed. */
    this.follow = () => {};
    this.hand = new Hand(this);
    this.paper = new Paper(this.say("scheme paper"), {
      press: (meant) => this.hand.press(meant),
      hover: (meant) => this.hand.hover(meant),
      release: (meant, drawn) => this.hand.release(meant, drawn),
      cancel: () => this.cancel(),
      begun: () => this.tell(this.say("scheme begun")),
      key: (event) => keyed(this, event),
      how: () => this.hand.how(),
    }, this.say("mm"));
    this.picture = new Picture(this);
    this.turning = new Turning(this);
    this.side = new Side(this);
    this.bar = new ToolBar(this);
    this.element = element("section", { class: "scheme" }, this.bar.element, this.paper.element, this.turning.element);
    this.changed();
  }

  /**
   * @param {string} key
   * @param {Record<string, string | number>} [values]
   */
  say(key, values = {}) {
    return (this.words[key] ?? key).replace(/\{(\w+)\}/g, (_, name) => String(values[name] ?? ""));
  }

  /** Show what is so now. */
  changed() {
    this.bar.show();
    this.paper.show(this.sketch, this.chosen, this.answer?.loads ?? []);
    this.side.show();
  }

  /** @param {Chosen} chosen */
  choose(chosen) {
    this.chosen = chosen;
    this.changed();
    if (chosen.letter !== undefined) this.tell(this.say("scheme chosen pin", { letter: chosen.letter }));
    if (chosen.number !== undefined) this.tell(this.say("scheme chosen link", { number: chosen.number }));
  }

  /**
   * Do something: show it, and have it judged.
   * @param {Sketch | null} sketch
   * @param {Chosen} [chosen]
   * @param {Partial<SchemeAct>} [more]
   */
  act(sketch, chosen = this.chosen, more = {}) {
    if (sketch === null) return this.tell(this.say("scheme nothing"));
    if (this.fixed) return this.tell(this.say("fixed"));
    const was = this.sketch;
    const drawn = this.ahead > 0 ? null : was;
    this.ahead += 1;
    this.sketch = sketch;
    this.chosen = chosen;
    this.changed();
    const by = () => ({ sketch: drawn !== null && this.answer !== null ? rebased(sketch, drawn, this.answer.sketch) : sketch, ...more });
    const before = () => {
      this.ahead -= 1;
      return this.history.keep({ ...this.moment, sketch: this.ahead > 0 ? was : (this.answer?.sketch ?? was) });
    };
    void this.ask(by, before);
  }

  /** What is now. @returns {Moment} */
  get moment() {
    const { sketch, text, answer, measured, origin } = this;
    return { sketch, text, answer, measured, origin };
  }

  /**
   * Send an act when those before it are answered; return why it was refused.
   * @param {() => Partial<SchemeAct>} act on what is by then
   * @param {() => Moment} before what is to be again if it is refused
   * @param {() => void} done what follows if it is not
   */
  ask(act, before = () => this.moment, done = () => {}) {
    this.waiting += 1;
    this.element.setAttribute("aria-busy", "true");
    const answered = this.queue.then(async () => {
      let was = before();
      const asked = { text: this.text, ...act() };
      const { answer, errors, newer } = await this.send(asked);
      this.waiting -= 1;
      this.element.setAttribute("aria-busy", String(this.waiting > 0));
      if (newer) was = this.overtaken(newer, was);
      if (answer === null) return this.undone(errors, was, asked.typed !== undefined && asked.section === undefined);
      this.side.refuse([]);
      this.take(answer);
      this.tell(this.hand.asks() || ([answer.says, ...answer.errors].find(Boolean) ?? ""));
      done();
      return [];
    });
    this.queue = answered.then(() => {});
    return answered;
  }

  /**
   * Return what was before an act if the file was another; what was done on its old text is not taken back over it.
   * @param {SchemeAnswer} newer
   * @param {Moment} before
   */
  overtaken(newer, before) {
    const kept = this.history.past.includes(before);
    const moment = { ...before, sketch: newer.sketch, text: newer.text ?? "", answer: newer };
    this.history = new History(BACK);
    return kept ? this.history.keep(moment) : moment;
  }

  /**
   * Take back an act that was refused, and those that were done on it; return why.
   * @param {string[]} errors
   * @param {Moment} before
   * @param {boolean} typed whether it was a value, which says so itself
   */
  undone(errors, before, typed) {
    const says = errors.length > 0 ? errors : [this.say("not sent")];
    this.history.forget(before);
    ({ sketch: this.sketch, text: this.text, answer: this.answer } = before);
    if (this.answer !== null) this.turning.follow(this.answer);
    this.changed();
    this.tell(says[0] ?? "");
    if (!typed) this.side.refuse(says);
    return says;
  }

  /**
   * Let the origin lie elsewhere, and what is drawn stay where it is seen.
   * @param {[number, number]} by m
   */
  shift(by) {
    this.paper.shift(by);
    this.picture.shift(by);
    this.origin = [this.origin[0] + by[0], this.origin[1] + by[1]];
  }

  /** @param {SchemeAnswer} answer */
  take(answer) {
    this.answer = answer;
    this.shift(answer.shift);
    if (answer.text !== null) this.text = answer.text;
    if (this.ahead === 0) this.sketch = answer.sketch;
    if (this.chosen.letter !== undefined && !(this.chosen.letter in this.sketch.places)) this.chosen = {};
    if (this.chosen.number !== undefined && bodyOf(this.sketch, this.chosen.number) === undefined) this.chosen = {};
    this.turning.follow(answer);
    this.follow();
    this.changed();
  }

  /**
   * Take the scene as its file is now.
   * @param {Partial<SchemeAct>} file what asks for it
   */
  async reload(file) {
    let { text } = this;
    this.measured = true;
    const seen = text === "" ? seenBefore() : null;
    const asked = (/** @type {SchemeAnswer["at"]} */ at) => this.ask(() => ({ ...file, at }), () => {
      text = this.text;
      return this.moment;
    });
    const refused = await asked(this.answer?.at ?? seen?.at ?? null);
    // with other lengths it may not be assembled there
    if (refused.length > 0 && seen !== null) await asked(null);
    if (text !== this.text) this.history = new History(BACK);
    if (text === "" && this.text !== "") lookAgain(this, seen);
    this.bar.show();
  }

  /**
   * Begin with what there is.
   * @param {string} text
   * @param {Sketch} sketch
   */
  async begin(text, sketch) {
    this.text = text;
    this.sketch = sketch;
    await this.ask(() => (text === "" ? { sketch } : {}));
    // who draws already, before this was answered, looks at what he draws
    if (this.ahead === 0 && this.history.past.length === 0 && this.sketch.links.length > 1) this.paper.fit();
  }

  cancel() {
    this.hand.cancel();
    this.choose({});
  }
}
