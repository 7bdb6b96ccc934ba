import { element, filled, iconButton, sentenceOf } from "./dom.js";
import { listenToKeys } from "./keys.js";
import { toggle } from "./run.js";
import { Stage } from "./stage.js";
import { tellingOf } from "./telling.js";
import { linesOfPictures } from "./told.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Line} Line
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

/**
 * Build the way of looking in which a plan is drawn step by step.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function playRoom(data, state) {
  const words = data.words;
  const say = (/** @type {string} */ key) => words[key] ?? key;
  const paper = element("div", { class: "paper" });
  const sentence = element("div", { class: "telling" });
  const count = element("p", { class: "count" });
  const list = element("ol", { class: "steps", "aria-label": say("steps") });
  const plans = chooser(data, state);
  const run = iconButton(ICONS.run, say("run"), () => toggle(state));
  const step = (/** @type {number} */ by) => () => state.go({ picture: state.place.picture + by });
  const bar = element(
    "div",
    { class: "bar", role: "toolbar", "aria-label": say("play") },
    iconButton(ICONS.first, say("first"), () => state.go({ picture: 0 })),
    iconButton(ICONS.previous, say("previous"), step(-1)),
    run,
    iconButton(ICONS.next, say("next"), step(1)),
    iconButton(ICONS.last, say("last"), () => state.go({ picture: Infinity })),
    count,
  );

  /**
   * @param {string} icon
   * @param {string} name
   */
  function dress(icon, name) {
    run.querySelector("path")?.setAttribute("d", icon);
    run.setAttribute("aria-label", name);
    run.title = name;
  }

  listenToKeys(state, "play", {
    ArrowRight: step(1),
    ArrowLeft: step(-1),
    PageDown: step(1),
    PageUp: step(-1),
    Home: () => state.go({ picture: 0 }),
    End: () => state.go({ picture: Infinity }),
    " ": () => toggle(state),
  });

  /** @type {Stage | null} */
  let stage = null;
  /** @type {Line[][]} */
  let told = [];
  state.hear((place) => {
    if (place.tab !== "play" || state.views.length === 0) return;
    const view = state.view;
    if (stage?.view !== view) {
      stage = new Stage(view);
      told = linesOfPictures(view);
      paper.replaceChildren(stage.svg);
      list.replaceChildren(...told.map((lines, n) => item(lines, n)));
    }
    stage.show(place.picture);
    dress(place.running ? ICONS.pause : ICONS.run, say(place.running ? "pause" : "run"));
    count.textContent = filled(say("step of"), { step: place.picture, count: view.pictures.length });
    sentence.replaceChildren(...tellingOf(data, view, place.picture));
    [...list.children].forEach((one, n) => {
      if (n === place.picture) one.setAttribute("aria-current", "step");
      else one.removeAttribute("aria-current");
    });
  });

  /**
   * @param {Line[]} lines
   * @param {number} n
   */
  function item(lines, n) {
    const made = element("li", {}, ...lines.map((line) => element("p", {}, ...sentenceOf(line.text))));
    made.addEventListener("click", () => state.go({ picture: n }));
    if (lines.length === 0) made.append(element("p", {}, n === 0 ? say("given") : ""));
    return made;
  }

  const panel = element("div", { class: "panel" }, sentence, list);
  return element("section", { id: "play", "aria-label": say("play") }, plans, element("div", { class: "board" }, paper, panel), bar);
}

/**
 * Return the choice of the plan and of its position.
 * @param {Data} data
 * @param {State} state
 */
function chooser(data, state) {
  const plan = /** @type {HTMLSelectElement} */ (element("select", {}));
  const position = /** @type {HTMLSelectElement} */ (element("select", {}));
  const families = [...new Set(data.views.map((view) => view.family))];
  plan.append(...families.map((name) => element("option", { value: name }, name)));
  plan.addEventListener("change", () =>
    state.go({ view: data.views.findIndex((view) => view.family === plan.value), picture: 0 }),
  );
  position.addEventListener("change", () => state.go({ view: Number(position.value), picture: state.place.picture }));
  const places = element("label", {}, `${data.words["position"]} `, position);
  state.hear((place) => {
    const view = data.views[place.view];
    if (view === undefined) return;
    plan.value = view.family;
    const among = data.views.flatMap((one, k) => (one.family === view.family && one.position ? [k] : []));
    position.replaceChildren(
      ...among.map((k) => element("option", { value: String(k) }, data.views[k]?.position ?? "")),
    );
    position.value = String(place.view);
    places.hidden = among.length === 0;
  });
  return element("p", { class: "chooser" }, element("label", {}, `${data.words["plan"]} `, plan), places);
}
