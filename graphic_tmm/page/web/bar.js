import { element, filled, iconButton } from "./dom.js";
import { setPace, toggle } from "./run.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

const ICONS = {
  first: "M6 5v14M19 5 9 12l10 7z",
  previous: "M16 5 7 12l9 7z",
  run: "M7 4v16l13-8z",
  pause: "M7 5v14M16 5v14",
  next: "M8 5l9 7-9 7z",
  last: "M18 5v14M5 5l10 7-10 7z",
};
/** How long a step may be left standing, s; the usual one first. */
const PACES = [2, 1, 4, 8];

/**
 * Return the bar that steps through a plan: first, previous, run, next, last, how far it is, the pace.
 * @param {Data} data
 * @param {State} state
 */
export function playBar(data, state) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const count = element("p", { class: "count" });
  const run = iconButton(ICONS.run, say("run"), () => toggle(state));
  const step = (/** @type {number} */ by) => () => state.go({ picture: state.place.picture + by });
  const pace = /** @type {HTMLSelectElement} */ (element("select", { "aria-label": say("pace") }));
  for (const seconds of [...PACES].sort((a, b) => a - b)) {
    pace.append(element("option", { value: String(seconds) }, filled(say("seconds"), { n: seconds })));
  }
  pace.value = String(PACES[0]);
  pace.addEventListener("change", () => setPace(state, 1000 * Number(pace.value)));
  setPace(state, 1000 * Number(pace.value));
  state.hear((place) => {
    const name = say(place.running ? "pause" : "run");
    run.querySelector("path")?.setAttribute("d", place.running ? ICONS.pause : ICONS.run);
    run.setAttribute("aria-label", name);
    run.title = name;
    const all = state.views[place.view]?.pictures.length ?? 0;
    count.textContent = filled(say("step of"), { step: place.picture, count: all });
  });
  return element(
    "div",
    { class: "bar", role: "toolbar", "aria-label": say("play") },
    iconButton(ICONS.first, say("first"), () => state.go({ picture: 0 })),
    iconButton(ICONS.previous, say("previous"), step(-1)),
    run,
    iconButton(ICONS.next, say("next"), step(1)),
    iconButton(ICONS.last, say("last"), () => state.go({ picture: Infinity })),
    count,
    pace,
  );
}
