import { element, filled, sentenceOf, typeset } from "./dom.js";
import { linesOfPictures } from "./told.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Line} Line
 * @typedef {import("./types.js").View} View
 */

/**
 * Return what is told with a picture of a view: paragraphs of the classes step, remark, why, calc.
 * @param {Data} data
 * @param {View} view
 * @param {number} n
 * @returns {HTMLElement[]}
 */
export function tellingOf(data, view, n) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  if (n === 0) return [element("p", { class: "step" }, say("given"))];
  if (n >= view.pictures.length) return [element("p", { class: "step" }, say("ready"))];
  const picture = view.pictures[n];
  const name = view.names[String(picture?.at)] ?? "";
  const head = picture?.again ? [element("p", { class: "step" }, filled(say("again"), { name }))] : [];
  const lines = linesOfPictures(view)[n] ?? [];
  return [...head, ...lines.flatMap((line) => tellingOfLine(line, say("why")))];
}

/**
 * @param {Line} line
 * @param {string} why
 * @returns {HTMLElement[]}
 */
function tellingOfLine(line, why) {
  const number = line.n ? [element("b", {}, `${line.n}. `)] : [];
  const made = [element("p", { class: line.n ? "step" : "remark" }, ...number, ...sentenceOf(line.text))];
  if (line.why) made.push(element("p", { class: "why" }, `${why}: `, ...sentenceOf(line.why)));
  if (line.calc) made.push(element("p", { class: "calc" }, ...typeset(line.calc)));
  return made;
}
