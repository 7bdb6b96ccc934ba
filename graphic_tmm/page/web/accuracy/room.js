import { drawnElement, element, filled, typeset } from "../dom.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").ErrorShares} ErrorShares
 * @typedef {import("../state.js").State} State
 */

/** How dark a source is, the largest first; those behind are as the last. */
const SHADES = ["0.85", "0.6", "0.4", "0.25", "0.12", "0"];

/**
 * The room of accuracy is there already; beside each plan that is played it tells where the errors come from.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function accuracyRoom(data, state) {
  const errors = element("div", { class: "errors" });
  document.querySelector("#play .words")?.append(errors);
  let shown = -1;
  state.hear((place) => {
    if (place.tab !== "play" || place.view === shown) return;
    shown = place.view;
    const there = (data.accuracy ?? []).filter((one) => one.views.includes(place.view));
    errors.replaceChildren(...there.map((one) => errorsOf(data, one, state)));
  });
  const room = /** @type {HTMLElement} */ (document.getElementById("accuracy"));
  room.tabIndex = 0; // keys move it where it is higher than its window
  return room;
}

/**
 * @param {Data} data
 * @param {ErrorShares} one
 * @param {State} state
 */
function errorsOf(data, one, state) {
  const head = data.words[one.student ? "error by student" : "error from"] ?? "";
  const told = element("section", {}, element("h3", {}, ...typeset(filled(head, { quantity: one.quantity }))));
  told.append(errorBar(one));
  const list = element("ul", {});
  one.shares.forEach(([name, , percent], k) => {
    list.append(element("li", {}, errorShade(k), ` ${name} ${percent} %`));
  });
  told.append(list);
  if (one.most !== undefined) told.append(element("p", {}, ...typeset(one.most)));
  if (one.stop !== undefined) told.append(wayToStep(data, one.stop, state));
  return told;
}

/**
 * Return a bar of the shares, for the eye: the list below tells them in words.
 * @param {ErrorShares} one
 */
function errorBar(one) {
  const bar = drawnElement("svg", { class: "shares", viewBox: "0 0 100 8", preserveAspectRatio: "none", "aria-hidden": "true" });
  let at = 0;
  one.shares.forEach(([, share], k) => {
    bar.append(errorShare(k, at, share, 8));
    at += share;
  });
  return bar;
}

/** @param {number} k */
function errorShade(k) {
  return drawnElement("svg", { class: "shade", viewBox: "0 0 8 8", "aria-hidden": "true" }, errorShare(k, 0, 8, 8));
}

/**
 * @param {number} k
 * @param {number} x
 * @param {number} width
 * @param {number} height
 */
function errorShare(k, x, width, height) {
  const shade = SHADES[Math.min(k, SHADES.length - 1)] ?? "0";
  return drawnElement("rect", { x, y: 0, width, height, "fill-opacity": shade });
}

/**
 * Return a button that goes to the step which brings most.
 * @param {Data} data
 * @param {[number, number]} stop
 * @param {State} state
 */
function wayToStep(data, [view, picture], state) {
  const title = data.views[view]?.title ?? "";
  const go = element("button", { type: "button", title }, data.words["error step"] ?? "");
  go.addEventListener("click", () => state.go({ tab: "play", view, picture }));
  return go;
}
