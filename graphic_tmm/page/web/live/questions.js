import { fourFigures } from "../crank-values.js";
import { element, filled, typeset } from "../dom.js";
import { strokesOf } from "./travel.js";

/**
 * @typedef {import("../types.js").LiveData} LiveData
 * @typedef {import("../types.js").Output} Output
 * @typedef {import("../types.js").Slider} Slider
 * @typedef {import("./travel.js").Strokes} Strokes
 * @typedef {import("./run.js").LiveRun} LiveRun
 * @typedef {{kind: "ratio" | "travel" | "most" | "least", slider: Slider, target: number}} Question an answer is a
 *   value of the slider with which K_v or the travel is the target, or the bound itself
 */

/** A question is of what becomes of a length that is so many times what is given. */
const TRIED = [1.2, 0.8];
/** What changes by less is not asked for: K_v, and the share of a travel. */
const ASKED = { ratio: 0.05, travel: 0.03 };
/** A bound is looked for so far, in so many steps, then in halves. */
const [STRETCHED, STRIDES, HALVES] = [3, 20, 20];
/** An answer is right to so much: K_v as it is written, of a travel or a bound a share. */
const RIGHT = { ratio: 0.005, travel: 0.005, bound: 0.01 };
/** The letter of the ratio of the mean speeds. */
const RATIO = "K_{v}";

/** What a mechanism does, asked of the run of its log with lengths other than it stands with. */
export class Trials {
  /**
   * @param {LiveRun} run
   * @param {Output} out
   * @param {(k: number) => string} broken why there is nothing at an angle
   */
  constructor(run, out, broken) {
    this.run = run;
    this.out = out;
    this.broken = broken;
    const { slot, pivot = slot } = out;
    run.kept = [...run.kept, slot, pivot];
  }

  /** What it does as it stands. */
  now() {
    const { run } = this;
    const rows = Array.from({ length: this.out.turn }, (_, k) => run.few(k));
    return strokesOf(this.out, rows, Number(run.alike[this.out.scale]));
  }

  /** Whether it can be assembled over the whole turn as it stands. */
  turns() {
    for (let k = 0; k < this.out.turn; k++) if (this.broken(k) !== "") return false;
    return true;
  }

  /**
   * @param {Slider} slider
   * @param {number} value
   */
  give(slider, value) {
    this.run.give(new Map(slider.slots.map((slot) => [slot, value])));
  }
}

/**
 * Return three questions, or fewer: for which length K_v and the travel are others, and how far one goes at the most.
 * The run is left with another length.
 * @param {Trials} trials
 * @param {Slider[]} sliders
 * @returns {Question[]}
 */
export function askedOf(trials, sliders) {
  const lengths = sliders.filter((one) => one.by === 1000 && one.plan === undefined && one.v > 0);
  trials.run.give(new Map());
  const given = trials.turns() ? trials.now() : null;
  const tried = given === null ? [] : triedWith(trials, lengths);
  /** @type {Question[]} */
  const made = [];
  const free = (/** @type {Slider} */ slider) => made.every((one) => one.slider !== slider);
  for (const kind of /** @type {("ratio" | "travel")[]} */ (["ratio", "travel"])) {
    if (given === null) continue;
    const off = (/** @type {{found: Strokes}} */ one) => Math.abs(one.found[kind] - given[kind]) / (kind === "ratio" ? 1 : given[kind]);
    const seen = tried.filter((one) => off(one) > ASKED[kind]).sort((one, other) => off(other) - off(one));
    const best = seen.find((one) => free(one.slider)) ?? seen[0];
    if (best !== undefined) made.push({ kind, slider: best.slider, target: asRead(best.found[kind], kind) });
  }
  for (const slider of [...lengths.filter(free), ...lengths]) {
    const bound = boundOf(trials, slider);
    if (bound !== null) return [...made, bound];
  }
  return made;
}

/**
 * Return what a mechanism does with each of some lengths longer, and shorter, where it turns round.
 * @param {Trials} trials
 * @param {Slider[]} lengths
 */
function triedWith(trials, lengths) {
  /** @type {{slider: Slider, found: Strokes}[]} */
  const tried = [];
  for (const slider of lengths) {
    for (const times of TRIED) {
      trials.give(slider, slider.v * times);
      const found = trials.turns() ? trials.now() : null;
      if (found !== null) tried.push({ slider, found });
    }
  }
  return tried;
}

/**
 * Return how large, or else how small, a length may be for the crank to turn round; null if it may be any, or
 * hardly another.
 * @param {Trials} trials
 * @param {Slider} slider
 * @returns {Question | null}
 */
function boundOf(trials, slider) {
  for (const [kind, end] of /** @type {["most" | "least", number][]} */ ([["most", STRETCHED], ["least", 0]])) {
    const turns = (/** @type {number} */ times) => {
      trials.give(slider, slider.v * times);
      return trials.turns();
    };
    const strides = Array.from({ length: STRIDES - 1 }, (_, n) => 1 + ((end - 1) * (n + 1)) / STRIDES);
    const stop = strides.findIndex((times) => !turns(times));
    if (stop < 0 || !turns(1)) continue;
    let [good, bad] = [strides[stop - 1] ?? 1, strides[stop] ?? end];
    for (let n = 0; n < HALVES; n++) {
      const middle = (good + bad) / 2;
      if (turns(middle)) good = middle;
      else bad = middle;
    }
    if (Math.abs(good - 1) > RIGHT.bound) return { kind, slider, target: good * slider.v };
  }
  return null;
}

/**
 * @param {number} value
 * @param {"ratio" | "travel"} kind
 */
function asRead(value, kind) {
  return Number(kind === "ratio" ? value.toFixed(2) : value.toPrecision(3));
}

/**
 * Tell whether what a mechanism does with a length answers a question.
 * @param {Question} asked
 * @param {number} value of its slider
 * @param {boolean} turns
 * @param {Strokes | null} now
 */
export function isRight({ kind, target }, value, turns, now) {
  if (!turns) return false;
  if (kind === "ratio") return now !== null && Math.abs(now.ratio - target) <= RIGHT.ratio;
  if (kind === "travel") return now !== null && Math.abs(now.travel / target - 1) <= RIGHT.travel;
  return Math.abs(value / target - 1) <= RIGHT.bound;
}

/**
 * Return the questions in words, asked when they are opened, and what judges them; null where there is nothing to ask.
 * @param {Trials} trials
 * @param {LiveData} live
 * @param {(key: string) => string} say
 * @param {string} decimal
 * @param {() => void} restore gives the run what it had
 */
export function questionsPanel(trials, live, say, decimal, restore) {
  const list = element("ol");
  const how = element("p", {}, say("how answered"));
  const made = element("details", { class: "questions" }, element("summary", {}, say("questions")), how, list);
  /** The questions, what is said of each, whether it was answered. @type {{asked: Question, says: HTMLElement, solved: boolean}[] | null} */
  let rows = null;
  /** @type {Map<Slider, number>} */
  let values = new Map();
  const link = trials.out.pivot !== undefined;
  const figure = (/** @type {number} */ value) => fourFigures(value, decimal);
  // a travel along a line is told in mm
  const inUnits = (/** @type {Question["kind"]} */ kind, /** @type {number} */ value) =>
    kind === "ratio" ? value.toFixed(2).replace(".", decimal) : figure(link || kind !== "travel" ? value : value * 1000);

  made.addEventListener("toggle", () => {
    if (!(/** @type {HTMLDetailsElement} */ (made).open) || rows !== null) return;
    rows = askedOf(trials, live.sliders).map((asked) => {
      const says = element("p", { role: "status" });
      const key = asked.kind === "most" || asked.kind === "least" ? `ask ${asked.kind}` : `ask ${asked.kind} ${link ? "link" : "point"}`;
      const told = { letter: asked.slider.l, point: trials.out.l, ratio: RATIO, target: inUnits(asked.kind, asked.target) };
      list.append(element("li", {}, ...typeset(filled(say(key), told)), says));
      return { asked, says, solved: false };
    });
    if (rows.length === 0) how.textContent = say("asks nothing");
    restore();
    judge(values);
  });

  /**
   * @param {Map<Slider, number>} given those that are not as in the scene
   * @param {boolean} refused whether nothing can be assembled with them
   */
  function judge(given, refused = false) {
    values = new Map(given);
    if (rows === null) return;
    const turns = !refused && trials.turns();
    const now = turns ? trials.now() : null;
    for (const row of rows) {
      const { asked, says } = row;
      const right = alone(asked.slider) && isRight(asked, values.get(asked.slider) ?? asked.slider.v, turns, now);
      row.solved ||= right;
      const done = right || (row.solved && !values.has(asked.slider));
      says.classList.toggle("right", done);
      says.replaceChildren(...typeset(done ? say("answer right") : answer(asked, turns, now)));
    }
  }

  /** @param {Slider} slider */
  function alone(slider) {
    return [...values.keys()].every((one) => one === slider);
  }

  /**
   * @param {Question} asked
   * @param {boolean} turns
   * @param {Strokes | null} now
   */
  function answer({ kind, slider }, turns, now) {
    if (!alone(slider)) return values.has(slider) ? say("answer others") : "";
    if (!turns) return say("answer stops");
    if (kind === "most" || kind === "least") return values.size === 0 ? "" : filled(say("answer turns"), { letter: slider.l });
    return now === null ? "" : filled(say("answer now"), { value: inUnits(kind, now[kind]) });
  }

  return { element: made, judge };
}
