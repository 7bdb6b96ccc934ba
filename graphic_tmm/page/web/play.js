import { stepBar } from "./bar.js";
import { chooser } from "./chooser.js";
import { element, sentenceOf } from "./dom.js";
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
  const list = element("ol", { class: "steps", "aria-label": say("steps") });
  const plans = chooser(data, state);
  const step = (/** @type {number} */ by) => () => state.go({ picture: state.place.picture + by });
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

  const panel = element("div", { class: "panel", tabindex: "0" }, sentence, list);
  return element("section", { id: "play", "aria-label": say("play") }, plans, element("div", { class: "board" }, paper, panel), stepBar(data, state));
}
