import { element } from "../dom.js";
import { listenToKeys } from "../keys.js";
import { LENGTHS } from "../lengths.js";
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
  /** Where the address was when it was looked at last. */
  let seen = "";
  state.hear((place, before) => {
    if (place.tab !== "practice" || data.practice === undefined || data.practice.tasks.length === 0) return;
    work ??= fillPractice(room, data, data.practice, state);
    work.give(LENGTHS.given);
    const now = `${place.view} ${place.picture}`;
    if (now === seen) return;
    const begun = seen === "";
    seen = now;
    const chosen = state.named || before.tab === "practice"; // elsewhere the number is a picture's
    const near = taskNear(data.practice, state.view, chosen ? place.picture : -1, begun);
    if (near !== work.n) work.go(near);
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
    const found = placeOfTask(data, practice, n);
    if (found !== null && (found.view !== state.place.view || (found.picture ?? state.place.picture) !== state.place.picture)) state.go(found);
  });
  const chooser = taskChooser(practice, say, (n) => work.go(n));
  room.append(chooser.whole, work.paper.whole, work.panel.goal, work.panel.palette.whole, work.panel.body);
  lightAlike(room, () => state.view);
  return work;
}

/**
 * Return where the address says that a task is: the view that shows it, its number there if that shows all positions.
 * @param {Data} data
 * @param {Practice} practice
 * @param {number} n
 * @returns {{view: number, picture?: number} | null}
 */
function placeOfTask(data, practice, n) {
  const task = practice.tasks[n];
  const shown = data.views[task?.view ?? -1];
  if (task === undefined || shown === undefined) return null;
  if (shown.position !== "") return { view: task.view };
  const key = Object.keys(shown.names).find((one) => shown.names[one] === practice.names[task.at]);
  return { view: task.view, picture: Number(key ?? 0) };
}
