import { element, typeset } from "./dom.js";
import { headsAt } from "./told.js";

/**
 * @typedef {import("./types.js").Equation} Equation
 * @typedef {import("./types.js").Term} Term
 * @typedef {import("./types.js").View} View
 */

/**
 * Return what stands above the step of a stop: its group, the vector equation as far as it is drawn.
 * @param {View} view
 * @param {number} n
 * @returns {HTMLElement[]}
 */
export function groupOf(view, n) {
  return headsAt(view, n).map((line) =>
    line.equation
      ? equationOf(line.equation, n)
      : element("p", { class: "group" }, ...(line.text ?? []).flatMap((run) => typeset(String(run)))),
  );
}

/**
 * Return a vector equation as it stands on the sheet: a bar above each letter, below it two lines where the vector is
 * known wholly, one where its direction is. What is drawn by now is inked, what this step draws is marked.
 * @param {Equation} equation
 * @param {number} n the stop; beyond the last one all is drawn
 * @returns {HTMLElement}
 */
export function equationOf(equation, n) {
  const ways = equation.ways ? [element("span", { class: "ways" }, ...typeset(equation.ways))] : [];
  return element("p", { class: "equation" }, sumOf(equation, n), ...ways);
}

/**
 * Return the sides of a vector equation, without the directions that are known.
 * @param {Equation} equation
 * @param {number} n
 */
export function sumOf(equation, n) {
  const sides = equation.sides.map((side, k) => [
    ...(k > 0 ? [" = "] : []),
    ...side.flatMap((term, m) => [...(m > 0 ? [" + "] : []), termOf(term, n)]),
  ]);
  return element("span", { class: "sum" }, ...sides.flat());
}

/**
 * @param {Term} term
 * @param {number} n
 */
function termOf(term, n) {
  if (term.of.length === 0) return element("span", {}, term.s);
  const known = term.to <= n ? "whole" : term.from <= n ? "begun" : "unknown";
  const now = term.to === n || term.from === n ? " now" : "";
  const letter = element("span", { class: "over" }, term.s.slice(0, 1));
  const body = element("span", { class: `lines${term.u}` }, letter, ...typeset(term.s.slice(1)));
  return element("span", { class: `term ${known}${now}`, "data-of": term.of.join(" ") }, body);
}
