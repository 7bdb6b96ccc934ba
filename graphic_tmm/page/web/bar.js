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

/** How long a step may be left standing, s, and usually is. */
const PACES = [1, 2, 4, 8];
const USUAL = 2;

/**
 * Return the choice of the pace at which steps follow by themselves.
 * @param {Data} data
 * @param {State} state
 */
export function paceChooser(data, state) {
  const pace = /** @type {HTMLSelectElement} */ (element("select", { "aria-label": data.words["pace"] ?? "", class: "pace" }));
  for (const n of PACES) pace.append(element("option", { value: String(n) }, filled(data.words["seconds"] ?? "", { n })));
  pace.value = String(USUAL);
  pace.addEventListener("change", () => setPace(state, 1000 * Number(pace.value)));
  setPace(state, 1000 * USUAL);
  return pace;
}

/**
 * Return the buttons that go through the stops of a view, and how far it is drawn.
 * @param {Data} data
 * @param {State} state
 */
export function stepBar(data, state) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const count = element("p", { class: "count" });
  const run = iconButton(ICONS.run, say("run"), () => toggle(state));
  state.hear((place) => {
    const key = place.running ? "pause" : "run";
    run.querySelector("path")?.setAttribute("d", ICONS[key]);
    run.setAttribute("aria-label", say(key));
    run.title = say(key);
    const pictures = data.views[place.view]?.pictures.length ?? 0;
    count.textContent = filled(say("step of"), { step: place.picture, count: pictures });
  });
  return element(
    "div",
    { class: "bar", role: "toolbar", "aria-label": say("play") },
    iconButton(ICONS.first, say("first"), () => state.go({ picture: 0 })),
    iconButton(ICONS.previous, say("previous"), () => state.go({ picture: state.place.picture - 1 })),
    run,
    iconButton(ICONS.next, say("next"), () => state.go({ picture: state.place.picture + 1 })),
    iconButton(ICONS.last, say("last"), () => state.go({ picture: Infinity })),
    count,
  );
}
