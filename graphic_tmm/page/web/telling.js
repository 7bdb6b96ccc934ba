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
  if (line.calc) made.push(element("p", { class: "calc", ...of }, ...breakable(typeset(line.calc))));
  if (line.row) made.push(element("p", { class: "reading", "data-of": line.row[0].join(" ") }, ...readingOf(line.row, line.read)));
  if (line.sign) made.push(element("p", { class: "remark" }, line.sign));
  if (line.why) made.push(element("p", { class: "why" }, `${why}: `, ...sentenceOf(line.why)));
  return made;
}

/**
 * Return a formula that may go on in the next line behind a sign, never within a number.
 * @param {(Node | string)[]} nodes
 * @returns {(Node | string)[]}
 */
function breakable(nodes) {
  /** @type {(Node | string)[]} */
  const found = [];
  for (const node of nodes) {
    const parts = typeof node === "string" ? node.split(/(?<=[·/])/) : [node];
    parts.forEach((part, k) => found.push(...(k > 0 ? [element("wbr"), part] : [part])));
  }
  return found;
}

/**
 * Return what was read off the drawing and what it stands for: BA = 115,0 mm × 0,004 m/mm = 0,460 m.
 * @param {Row} row
 * @param {string} [signed] what was read, where it has a sign
 * @returns {(Node | string)[]}
 */
export function readingOf([, segment, mm, mu, value, quantity], signed = mm) {
  if (mm === "") return pieces([[...typeset(segment), ` = ${value}`]]);
  const read = [...typeset(segment), ` = ${signed}`];
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
