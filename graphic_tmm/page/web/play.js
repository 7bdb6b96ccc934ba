import { paceChooser, stepBar } from "./bar.js";
import { chooser } from "./chooser.js";
import { element } from "./dom.js";
import { keepReadable } from "./enlarge.js";
import { groupOf } from "./equation.js";
import { insetOf, insetSwitch } from "./inset.js";
import { listenToKeys } from "./keys.js";
import { lightAlike } from "./light.js";
import { toggle } from "./run.js";
import { Stage } from "./stage.js";
import { StepList } from "./steplist.js";
import { tellingOf } from "./telling.js";
import { madeIn } from "./told.js";
import { Tools, toolSwitch } from "./tools.js";
import { ValuesTable } from "./values.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").View} View
 * @typedef {import("./state.js").State} State
 * @typedef {{view: View, stage: Stage, tools: Tools, inset: ReturnType<typeof insetOf>, table: ValuesTable, list: StepList}} Shown
 */

/**
 * Build the way of looking in which a plan is drawn step by step.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function playRoom(data, state) {
  const paper = element("div", { class: "paper" });
  const group = element("div", { class: "heads" });
  const telling = element("div", { class: "telling" });
  const beside = element("div", { class: "beside" });
  const list = element("div", { class: "listed" });
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

  /** @type {Shown | null} */
  let shown = null;
  state.hear((place) => {
    if (place.tab !== "play" || state.views.length === 0) return;
    const view = state.view;
    if (shown?.view !== view) {
      const stage = new Stage(view);
      const table = new ValuesTable(data, view, madeIn(view));
      const steps = new StepList(data, view, (n) => state.go({ picture: n }));
      paper.replaceChildren(stage.svg);
      keepReadable(stage.svg);
      const inset = insetOf(data, view, stage.svg, paper);
      shown = { view, stage, tools: new Tools(stage.svg, view), inset, table, list: steps };
      beside.replaceChildren(table.table);
      list.replaceChildren(steps.whole);
    }
    const n = place.picture;
    shown.stage.show(n);
    shown.tools.show(n);
    shown.inset?.show(n);
    group.replaceChildren(...groupOf(view, n));
    telling.replaceChildren(...tellingOf(data, view, n));
    shown.table.show(n);
    shown.list.show(n);
  });

  const said = element("div", { class: "words", tabindex: "0" }, group, telling, beside);
  const options = element("div", { class: "options" }, paceChooser(data, state));
  const panel = element("div", { class: "panel", tabindex: "0" }, said, options, list);
  const board = element("div", { class: "board" }, paper, panel);
  const bar = stepBar(data, state);
  const legend = ["takes", "draws", "rubs"].map((key) => element("span", { class: key }, data.words[key] ?? ""));
  options.append(toolSwitch(data, board), insetSwitch(data), element("p", { class: "legend" }, ...legend));
  const room = element("section", { id: "play", "aria-label": data.words["play"] ?? "" }, chooser(data, state), board, bar);
  lightAlike(room, () => state.view);
  return room;
}
