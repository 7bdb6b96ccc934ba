import { element, filled, sentenceOf, typeset } from "./dom.js";
import { linesOfPictures } from "./told.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Line} Line
 * @typedef {import("./types.js").Row} Row
 * @typedef {import("./types.js").View} View
 */

/**
 * Return what is told in a stop of a view: paragraphs of the classes step, remark, tool, calc, reading, why.
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
  /** @type {HTMLElement[]} */
  const made = [];
  /** @type {Record<string, string>} */
  const of = line.it === undefined ? {} : { "data-of": String(line.it) };
  if (line.text) {
    made.push(element("p", { class: line.it === undefined ? "remark" : "step" }, ...sentenceOf(line.text)));
  }
  if (line.tool) made.push(element("p", { class: "tool" }, ...typeset(line.tool[1])));
  if (line.calc) made.push(element("p", { class: "calc", ...of }, ...typeset(line.calc)));
  if (line.row) made.push(element("p", { class: "reading", "data-of": line.row[0].join(" ") }, ...readingOf(line.row)));
  if (line.sign) made.push(element("p", { class: "remark" }, line.sign));
  if (line.why) made.push(element("p", { class: "why" }, `${why}: `, ...sentenceOf(line.why)));
  return made;
}

/**
 * Return what was read off the drawing and what it stands for: BA = 115,0 mm × 0,004 m/mm = 0,460 m.
 * @param {Row} row
 * @returns {(Node | string)[]}
 */
export function readingOf([, segment, mm, mu, value, quantity]) {
  if (mm === "") return pieces([[...typeset(segment), ` = ${value}`]]);
  const read = [...typeset(segment), ` = ${mm}`];
  if (mu === "") return pieces([read]);
  if (quantity === "") return pieces([read, [`× ${mu}`], [`= ${value}`]]);
  return pieces([read, ["→ ", ...typeset(quantity), ` = ${mm}`], [`× ${mu}`], [`= ${value}`]]);
}

/**
 * Return pieces of a line that is broken between them only.
 * @param {(Node | string)[][]} parts
 */
function pieces(parts) {
  return parts.flatMap((inner, k) => [...(k > 0 ? [" "] : []), element("span", { class: "piece" }, ...inner)]);
}
