import { done } from "./log.js";

/**
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").PracticeStep} PracticeStep
 * @typedef {import("./bench.js").Bench} Bench
 * @typedef {{slot: number} | {why: "not yet" | "no such step" | "done", near?: number}} Match the step that is done;
 *   or that it is none (`near`: one that is done with this instrument, or of these marks), that something it uses is
 *   missing, that it was done before
 */

/** What differs by no more is one, mm or of a direction. */
const SAME = 1e-6;
/** Marks that nobody lays an instrument to: they go without saying. */
const UNTOLD = ["number", "side", "angle"];

/**
 * Return which step an instrument does that is applied to marks: the step itself, or one that comes to the same.
 * @param {Bench} bench
 * @param {string} op
 * @param {number[]} uses
 * @param {number[]} [choice]
 * @returns {Match}
 */
export function matched(bench, op, uses, choice) {
  const steps = [...bench.own].flatMap((slot) => bench.log.steps.get(slot) ?? []);
  const own = steps.filter((step) => step.op === op && sameMarks(bench, step.uses, uses) && sameChoice(step, choice));
  const open = own.find((step) => !bench.made.has(step.it) && bench.ready(step.it));
  if (open !== undefined) return { slot: open.it };
  const [first] = own;
  if (first !== undefined) return { why: bench.made.has(first.it) ? "done" : "not yet", near: first.it };
  const there = uses.every((slot) => bench.value(slot) !== undefined);
  const left = steps.filter((step) => !bench.made.has(step.it) && (bench.ready(step.it) || isCrossed(step)));
  const alike = there ? left.find((step) => comesTo(bench, step, op, uses, choice)) : undefined;
  if (alike !== undefined) return { slot: alike.it };
  return nearest(bench, steps, op, uses);
}

/**
 * Whether other lines than a point's own meet there: it may be found before these are drawn.
 * @param {PracticeStep | undefined} step
 */
export function isCrossed(step) {
  return (step?.ways ?? []).some(([one]) => one[0] === "line");
}

/**
 * @param {Bench} bench
 * @param {PracticeStep[]} steps
 * @param {string} op
 * @param {number[]} uses
 * @returns {Match}
 */
function nearest(bench, steps, op, uses) {
  const left = steps.filter((step) => !bench.made.has(step.it));
  const near = left.find((step) => sameMarks(bench, step.uses, uses)) ?? left.find((step) => step.op === op);
  return near === undefined ? { why: "no such step" } : { why: "no such step", near: near.it };
}

/**
 * Whether the marks are those of a step, in any order; what goes without saying may be left out.
 * @param {Bench} bench
 * @param {number[]} due
 * @param {number[]} uses
 */
function sameMarks(bench, due, uses) {
  const told = (/** @type {number[]} */ slots) => slots.filter((slot) => !untold(bench, slot)).sort((a, b) => a - b).join(" ");
  return told(due) === told(uses);
}

/**
 * @param {Bench} bench
 * @param {number} slot
 */
function untold(bench, slot) {
  return !bench.own.has(slot) && UNTOLD.includes(bench.data.marks[String(slot)]?.k ?? "");
}

/**
 * @param {PracticeStep} step
 * @param {number[] | undefined} choice
 */
function sameChoice(step, choice) {
  return choice === undefined || (step.choice ?? []).every((one, k) => one === choice[k]);
}

/**
 * Whether an operation on marks comes to what a step leaves, were all drawn exactly.
 * @param {Bench} bench
 * @param {PracticeStep} step
 * @param {string} op
 * @param {number[]} uses
 * @param {number[]} [choice]
 */
function comesTo(bench, step, op, uses, choice) {
  const like = bench.log.data.steps.find((one) => one.op === op);
  const kinds = like?.uses.map((slot) => bench.data.marks[String(slot)]?.k);
  const given = uses.map((slot) => bench.data.marks[String(slot)]?.k);
  if (like === undefined || kinds === undefined || kinds.join(" ") !== given.join(" ")) return false;
  const values = uses.map((slot) => bench.log.exact.get(slot));
  const due = bench.log.exact.get(step.it);
  const chosen = choice ?? like.choice;
  const found = done(chosen === undefined ? { op } : { op, choice: chosen }, values);
  return due !== undefined && same(found, due);
}

/**
 * Whether two marks are one: two lines wherever they begin and whichever way they point.
 * @param {Drawn} one
 * @param {Drawn} other
 * @returns {boolean}
 */
export function same(one, other) {
  if (typeof one === "number" || typeof other === "number") return Math.abs(Number(one) - Number(other)) < SAME;
  if ("re" in one) return "re" in other && Math.hypot(one.re - other.re, one.im - other.im) < SAME;
  if ("radius" in one) return "radius" in other && same(one.centre, other.centre) && same(one.radius, other.radius);
  if (!("at" in other)) return false;
  const { along, at } = other;
  const turn = one.along.re * along.im - one.along.im * along.re;
  const aside = (one.at.re - at.re) * along.im - (one.at.im - at.im) * along.re;
  return Math.abs(turn) < SAME && Math.abs(aside) < SAME;
}
