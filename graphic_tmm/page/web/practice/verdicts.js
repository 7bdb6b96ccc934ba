import { element, filled, sentenceOf, typeset } from "../dom.js";
import { instrumentOf } from "./palette.js";
import { MISSED } from "./task.js";
import { plainSlip } from "./slips.js";
import { shownNumber } from "./typed.js";

/**
 * @typedef {import("./easel.js").Easel} Easel
 * @typedef {import("./task.js").Tried} Tried
 * @typedef {import("./task.js").Outcome} Outcome
 * @typedef {import("./task.js").Help} Help
 * @typedef {Node | string} Piece
 */

/** What is less is nobody's error, mm. */
const SLIGHT = 0.05;

/**
 * Whether an error that is right is worth a word.
 * @param {number} error
 * @param {unknown} found
 */
function isSeen(error, found) {
  return typeof found === "number" ? error > SLIGHT_SHARE * Math.abs(found) : error > SLIGHT;
}

/**
 * Whether something is to be said against a try.
 * @param {Tried} tried
 */
export function isPoor(tried) {
  return tried.missed || tried.verdict !== "fine";
}

/** What share of a figure is less than that is its last digit. */
const SLIGHT_SHARE = 0.001;

/** What is told of what a student did, in the words of the page. */
export class Verdicts {
  /**
   * @param {Easel} easel
   * @param {(key: string) => string} say
   */
  constructor(easel, say) {
    this.easel = easel;
    this.say = say;
  }

  /**
   * Return a sentence with the letter of a mark in it.
   * @param {string} key
   * @param {number} slot
   * @returns {Piece[]}
   */
  named(key, slot) {
    return this.say(key).split("{letter}").flatMap((text, k) => (k === 0 ? [text] : [...this.letter(slot), text]));
  }

  /**
   * @param {number} slot
   * @returns {Piece[]}
   */
  letter(slot) {
    return sentenceOf([[this.easel.letterOf(slot), slot]]);
  }

  /**
   * Return what is told of a try: the verdict, the step's own error, what it is off.
   * @param {Tried} tried
   */
  told(tried) {
    const lines = [element("p", { class: "verdict" }, this.say(tried.missed && tried.verdict !== "wrong" ? "missed" : tried.verdict))];
    const error = Math.abs(tried.error);
    const [size, unit] = this.sized(tried.slot, error);
    if (size !== "" && (isPoor(tried) || isSeen(error, tried.found))) {
      const told = this.say("own error").replace("{error}", size).replace("{unit}", unit);
      lines.push(element("p", { class: "error" }, told));
    }
    if (tried.missed) lines.push(element("p", { class: "error" }, filled(this.say("missed by"), { most: MISSED })));
    if (isPoor(tried)) lines.push(...this.blame(tried));
    return lines;
  }

  /**
   * Return how large an error is, and in which unit; "" of none.
   * @param {number} slot
   * @param {number} error
   * @returns {[string, string]}
   */
  sized(slot, error) {
    const { easel } = this;
    if (!Number.isFinite(error)) return ["", ""];
    if (easel.kindOf(slot) === "number") return [easel.numberOf(Number(error.toPrecision(2))), easel.unitOf(slot)];
    return [shownNumber(error, 1, easel.decimal), this.say("mm")];
  }

  /**
   * Return which lines a point is off, or that it is another meeting than the due one.
   * @param {Tried} tried
   */
  blame(tried) {
    const due = this.easel.bench.due(tried.slot);
    const plain = typeof tried.found === "number" && typeof due === "number" ? plainSlip(tried.found, due) : null;
    if (plain !== null) return [element("p", { class: "blame" }, filled(this.say(plain.key), { times: plain.times }))];
    const parts = this.easel.steps.get(tried.slot)?.parts ?? [];
    const found = tried.parts.map((part, k) => ({ ...part, kind: parts[k]?.[0] ?? "place", use: parts[k]?.[2] ?? 0 }));
    const other = found.find((part) => part.kind === "met" && part.error > SLIGHT);
    if (other !== undefined) return [element("p", { class: "blame" }, this.say("other meeting"))];
    return found
      .filter((part) => (part.kind === "line" || part.kind === "arc") && Math.abs(part.error) > SLIGHT)
      .map((part) => {
        const on = this.easel.steps.get(tried.slot)?.uses[part.use] ?? part.slot;
        const size = shownNumber(Math.abs(part.error), 1, this.easel.decimal);
        const told = this.say("off figure").replace("{error}", size).split("{letter}");
        return element("p", { class: "blame" }, ...told.flatMap((text, k) => (k === 0 ? [text] : [...this.letter(on), text])));
      });
  }

  /**
   * Return what is told where an instrument did nothing, or did it by itself.
   * @param {Outcome} outcome
   * @returns {HTMLElement[]}
   */
  outcome(outcome) {
    if (outcome.kind === "drawn") return [element("p", { class: "verdict" }, ...this.named("drawn", outcome.slot))];
    if (outcome.kind === "wrong side") return [element("p", { class: "verdict" }, this.say("wrong"))];
    if (outcome.kind === "undrawable") return [element("p", {}, ...this.named("undrawable", outcome.slot))];
    if (outcome.kind !== "none" || !("why" in outcome.answer)) return [];
    const { why, near } = outcome.answer;
    return [element("p", { class: "verdict" }, ...(near === undefined ? [this.say(why)] : this.named(why, near.it)))];
  }

  /**
   * Return what the button of a step's instrument is called.
   * @param {import("../types.js").PracticeStep | undefined} step
   */
  buttonOf(step) {
    return step === undefined ? "" : this.say(instrumentOf(step.op).name);
  }

  /**
   * Return a help: why a step is done, what is done, what it came to.
   * @param {Help} help
   * @returns {HTMLElement[]}
   */
  help({ slot, stage }) {
    const step = this.easel.steps.get(slot);
    if (stage === "why") return [element("p", {}, ...sentenceOf(step?.why ?? step?.text ?? []))];
    const lines = [element("p", {}, ...sentenceOf(step?.text ?? []))];
    lines.push(element("p", { class: "tool" }, filled(this.say("its button"), { name: this.buttonOf(step) })));
    if (step?.formula !== undefined) lines.push(element("p", { class: "calc" }, ...typeset(step.formula)));
    else if (step?.tool !== undefined) lines.push(element("p", { class: "tool" }, ...typeset(step.tool)));
    return lines;
  }
}
