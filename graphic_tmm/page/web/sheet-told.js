import { element, filled, sentenceOf, typeset } from "./dom.js";
import { titleOf } from "./sheet-desk.js";

/**
 * @typedef {import("./sheet-ink.js").Ink} Ink
 * @typedef {import("./sheet-ink.js").SheetInk} SheetInk
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").View} View
 * @typedef {import("./state.js").State} State
 */

/**
 * Return the ink of the same mark as one that was pointed at: all of its marks, its position.
 * @param {Ink} one
 * @param {Ink[]} shown
 * @param {(view: number) => string} board the board of a view of the sheet
 */
export function sameMark(one, shown, board) {
  if (one.of === "") return [one];
  const marks = one.of.split(" ");
  return shown.filter(
    (other) =>
      board(other.view) === board(one.view) &&
      (other.at < 0 || one.at < 0 || other.at === one.at) &&
      isSubset(marks, other.of.split(" ")),
  );
}

/**
 * @param {string[]} some
 * @param {string[]} all
 */
function isSubset(some, all) {
  return some.every((one) => all.includes(one));
}

/**
 * Return what is told of ink that was pointed at: what it is, the step that drew it, the way to that step.
 * @param {Ink} ink
 * @param {SheetInk} sheet
 * @param {Data} data
 * @param {View | undefined} view the view that is played, if it is one
 * @param {State} state
 */
export function toldOf(ink, sheet, data, view, state) {
  const title = titleOf(ink) || sheet.labels[ink.label]?.text || data.parts[ink.part] || "";
  const told = [element("b", {}, ...typeset(raised(title)))];
  const where = element("span", { class: "where" }, sheet.views[ink.view]?.title ?? "");
  if (view === undefined) return [...told, where];
  const line = lineOf(ink, view);
  if (line?.text !== undefined) told.push(element("span", {}, ...sentenceOf(line.text)));
  told.push(where);
  const key = `${ink.of}@${ink.at < 0 ? "" : ink.at}`;
  const picture = view.pictures.findIndex((one) => one.keys.includes(key));
  if (picture > 0) told.push(wayTo(data, data.views.indexOf(view), picture, state));
  return told;
}

/**
 * Return a button that goes to a step.
 * @param {Data} data
 * @param {number} view
 * @param {number} picture
 * @param {State} state
 */
function wayTo(data, view, picture, state) {
  const name = filled(data.words["show step"] ?? "", { step: picture });
  const go = element("button", { type: "button" }, name);
  go.addEventListener("click", () => state.go({ tab: "play", view, picture }));
  return go;
}

/**
 * Return the sentence of the step that drew ink: that of its last mark.
 * @param {Ink} ink
 * @param {View} view
 */
function lineOf(ink, view) {
  if (ink.of === "") return undefined;
  const marks = ink.of.split(" ").map(Number);
  const at = ink.at < 0 ? view.first : ink.at;
  const there = view.pictures.filter((picture) => picture.at === at);
  const lines = (there.length === 0 ? view.pictures : there).flatMap((picture) => picture.lines);
  return lines.findLast((line) => line.it !== undefined && marks.includes(line.it));
}

/**
 * Return a title of the sheet as mark-up: R63^n has its sign raised.
 * @param {string} title
 */
function raised(title) {
  return title.replace(/([_^])([^\s{}_^,;=]+)/g, "$1{$2}");
}
