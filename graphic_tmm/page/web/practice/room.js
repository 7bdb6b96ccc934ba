import { element } from "../dom.js";
import { listenToKeys } from "../keys.js";
import { lightAlike } from "../light.js";
import { Practising } from "./practising.js";
import { taskChooser, taskNear } from "./tasks.js";
import { INSTRUMENTS } from "./palette.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../state.js").State} State
 */

/**
 * Build the way of looking in which a student draws a plan himself; it is filled when it is looked at first.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function practiceRoom(data, state) {
  const room = element("section", { id: "practice" });
  /** @type {Practising | null} */
  let work = null;
  state.hear((place) => {
    if (place.tab !== "practice" || data.practice === undefined || data.practice.tasks.length === 0) return;
    work ??= fillPractice(room, data, data.practice, state);
    const near = taskNear(data.practice, state.view, place.picture);
    if (near >= 0 && work.n < 0) work.go(near);
  });
  const act = (/** @type {(own: Practising) => void} */ what) => () => {
    if (work !== null) what(work);
  };
  listenToKeys(state, "practice", {
    ...Object.fromEntries(INSTRUMENTS.map(({ name, key }) => [key, act((own) => own.choose(name, true))])),
    h: act((own) => own.help()),
    Enter: act((own) => own.enter()),
    Escape: act((own) => own.letGo()),
    Backspace: act((own) => own.letGo()),
  });
  return room;
}

/**
 * @param {HTMLElement} room
 * @param {Data} data
 * @param {Practice} practice
 * @param {State} state
 */
function fillPractice(room, data, practice, state) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const work = new Practising(data, say, (n) => {
    chooser.show(n);
    const task = practice.tasks[n];
    const view = task?.view ?? -1;
    if (view >= 0 && view !== state.place.view) state.go({ view });
  });
  const chooser = taskChooser(practice, say, (n) => work.go(n));
  room.append(chooser.whole, work.paper.whole, work.panel.palette.whole, work.panel.body);
  lightAlike(room, () => state.view);
  return work;
}
