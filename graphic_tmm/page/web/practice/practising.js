import { element, typeset } from "../dom.js";
import { actsOf } from "./acts.js";
import { beginningOf, rulerFor } from "./aids.js";
import { GRAIN } from "./aim.js";
import { insetOf } from "../inset.js";
import { Beside } from "./beside.js";
import { menuOf } from "./choices.js";
import { Panel } from "./panel.js";
import { Paper } from "./paper.js";
import { readAloud } from "./aloud.js";
import { Sessions } from "./session.js";
import { showWork } from "./showing.js";
import { cellOf, halfUnit } from "./typed.js";
import { Verdicts } from "./verdicts.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./task.js").Outcome} Outcome
 */

/** A student at the board: what is done by pointer or key goes to the task, what comes of it is shown. */
export class Practising {
  /**
   * @param {Data} data
   * @param {(key: string) => string} say
   * @param {(n: number) => void} went
   */
  constructor(data, say, went) {
    this.data = data;
    this.say = say;
    this.went = went;
    this.n = -1;
    this.sessions = new Sessions(data);
    /** @type {Spot | null} */
    this.aim = null;
    /** Where the cross stood before anything was done with it. @type {Spot | null} */
    this.begun = null;
    this.now = -1;
    this.panel = new Panel(say, data.words["decimal sign"] ?? ".", actsOf(this));
    this.paper = new Paper(say("board"), say("loupe"), (slots, at) => this.meant(slots, at), (spot) => this.aimAt(spot));
    this.beside = new Beside(say("mechanism"), (slots, at) => this.meant(slots, at));
    this.menu = element("div", { class: "meant", role: "group", "aria-label": say("meant"), hidden: "" });
    this.paper.whole.append(this.beside.svg, this.menu);
    /** The mechanism that is to be drawn, where it is the task. @type {ReturnType<typeof insetOf>} */
    this.scheme = null;
  }

  get session() {
    return this.sessions.of(this.n);
  }

  get task() {
    return this.session.task;
  }

  get easel() {
    return this.session.easel;
  }

  /**
   * Take what is given otherwise than in the scene.
   * @param {typeof import("../lengths.js").LENGTHS.given} given
   */
  give(given) {
    if (this.sessions.give(given) && this.n >= 0) this.go(this.n);
  }

  /**
   * Go to a task.
   * @param {number} n
   */
  go(n) {
    this.n = n;
    this.scheme?.svg.remove();
    this.paper.whole.classList.remove("across", "down");
    this.beside.begin(this.easel, this.session.mechanism);
    const { given: lead } = this.session;
    this.scheme = lead === undefined ? null : insetOf(this.data, lead, this.paper.svg, this.paper.whole);
    this.scheme?.svg.classList.add("begun");
    this.panel.goal.replaceChildren(...typeset(this.session.goal));
    this.aim = null;
    this.now = -1;
    for (const tell of [this.report, this.hinted]) tell.call(this, []);
    this.show();
    this.went(n);
  }

  /**
   * Take an instrument.
   * @param {string} name
   * @param {boolean} byKey then the keyboard goes on to what it is laid to
   */
  choose(name, byKey = false) {
    this.task.choose(name);
    this.report([]);
    this.show();
    if (byKey) this.panel.listing.go(0);
  }

  /** @param {number} slot */
  pick(slot) {
    this.menu.hidden = true;
    this.settle(this.task.pick(slot));
  }

  /**
   * Pick what was pointed at; of several in one place, what is chosen of them.
   * @param {number[]} slots
   * @param {[number, number]} at
   */
  meant(slots, at) {
    const [first] = slots;
    if (first === undefined && this.task.instrument !== null) this.report([element("p", {}, this.say("nothing here"))]);
    this.menu.hidden = slots.length < 2;
    if (slots.length > 1) menuOf(this.menu, at, slots, this.easel, (slot) => this.pick(slot));
    else if (first !== undefined) this.pick(first);
  }

  /** @param {Outcome} outcome */
  settle(outcome) {
    if (outcome.kind === "more") return this.show();
    if (outcome.kind === "drawn") this.finish(outcome.slot);
    if (outcome.kind === "asked") this.begin();
    this.report(new Verdicts(this.easel, this.say).outcome(outcome));
    this.show();
    if (outcome.kind === "asked") this.focus();
    else if (outcome.kind === "drawn" && this.panel.listing.whole.contains(document.activeElement)) this.panel.palette.rest();
  }

  /** An answer is due: the cross, the forms. */
  begin() {
    const move = /** @type {import("./picking.js").Move} */ (this.task.asked);
    const begun = this.easel.values.spot(move.it) ?? beginningOf(rulerFor(move, this.easel), this.session.frame);
    this.aim = this.easel.kindOf(move.it) === "point" ? begun : null;
    this.begun = this.aim;
    if (this.aim !== null) this.panel.spot.begin(this.easel.letterOf(this.session.told.pole));
    else this.panel.figure.begin(this.easel.letterOf(move.it), this.easel.unitOf(move.it));
  }

  focus() {
    if (this.aim !== null) this.paper.whole.focus({ preventScroll: true });
    else (this.panel.sides.find((one) => !one.hidden) ?? this.panel.figure.field).focus({ preventScroll: true });
  }

  /** @param {Spot} spot */
  aimAt(spot) {
    if (this.aim !== null) this.aim = spot;
    this.show();
  }

  prick() {
    if (this.aim === null) return;
    const [x, y] = this.aim;
    const texts = this.aim.map((one) => cellOf(one.toFixed(2), this.easel.decimal));
    this.judge({ re: x, im: y }, texts, { x: GRAIN / 2, y: GRAIN / 2 });
  }

  /**
   * @param {number} value
   * @param {string[]} texts
   */
  tell(value, texts) {
    const half = halfUnit(texts[0] ?? "");
    const length = this.easel.kindOf(this.task.asked?.it ?? -1) === "length";
    this.judge(value, texts, length ? { mm: half } : { value: half });
  }

  /**
   * @param {number | import("../types.js").Complex} found
   * @param {string[]} texts
   * @param {import("./judging.js").Last} last
   */
  judge(found, texts, last) {
    const tried = this.task.tell(found, texts, last);
    if (tried === null) return;
    if (this.task.asked === null) this.finish(tried.slot);
    this.report(new Verdicts(this.easel, this.say).told(tried));
    this.show();
    if (this.task.asked === null) this.panel.palette.rest();
  }

  leave() {
    this.finish(this.task.leave()?.slot);
    this.report([]);
    this.show();
    this.panel.palette.rest();
  }

  /** @param {number} slot */
  redo(slot) {
    this.task.redo(slot);
    this.begin();
    this.report([]);
    this.show();
    this.focus();
  }

  help() {
    const help = this.task.help();
    if (help === null) return;
    const [shown, lines] = [help.stage === "show", new Verdicts(this.easel, this.say).help(help)];
    if (shown) this.finish(help.slot);
    else this.hinted(lines);
    this.report(shown ? lines : []);
    this.show();
  }

  /** A step is done: what was told of it is told no more, what is done is kept. */
  finish(slot = this.now) {
    [this.now, this.aim] = [slot, null];
    this.hinted([]);
    this.session.keep();
  }

  /** Enter: that is all that is picked; mark it. */
  enter() {
    if (this.aim !== null) this.prick();
    else if (this.task.asked === null) this.settle(this.task.submit());
  }

  /** Let go of what was picked last, then of the instrument. */
  letGo() {
    const { task } = this;
    if (!this.menu.hidden) this.menu.hidden = true;
    else if (task.asked === null && task.picks.length > 0) task.picks = task.picks.slice(0, -1);
    else task.rest();
    this.aim = null;
    this.show();
  }

  show() {
    showWork(this);
  }

  /**
   * Tell how something was judged; it is read aloud too.
   * @param {HTMLElement[]} lines
   */
  report(lines) {
    this.panel.verdict.replaceChildren(...lines);
    readAloud(lines);
  }

  /** @param {HTMLElement[]} lines */
  hinted(lines) {
    this.panel.hint.replaceChildren(...lines);
    readAloud(lines);
  }
}
