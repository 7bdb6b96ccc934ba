import { element, filled, sentenceOf } from "../dom.js";
import { distancesFor, rulerFor } from "./aids.js";
import { groupsFor } from "./choices.js";
import { shapesOf } from "./shapes.js";
import { hasSides } from "./sides.js";
import { MISSED } from "./task.js";
import { isPoor, Verdicts } from "./verdicts.js";

/**
 * @typedef {import("./practising.js").Practising} Practising
 * @typedef {import("./paper.js").Shown} Shown
 */

/**
 * Show where a student is with a task: the board, the instruments, what is asked for.
 * @param {Practising} work
 */
export function showWork(work) {
  const { task, panel, easel, say } = work;
  panel.palette.show(task.instrument?.name ?? "");
  panel.prompt.replaceChildren(...promptOf(work));
  panel.listing.show(groupsFor(task, easel, say), task.picks);
  showAnswer(work);
  const taken = task.asked?.uses ?? [];
  panel.data.replaceChildren(...taken.flatMap((slot) => dataOf(easel.letterOf(slot), easel.toldOf(slot))));
  showAfter(work);
  panel.tally.show(task, easel);
  work.paper.show({ ...boardOf(work), taken: work.beside.stand(work.session.exact, work.session.frame) });
  work.beside.show((slot) => task.fits(slot), task.picks);
}

/**
 * Show what can be done now: pick, say that it is all, answer.
 * @param {Practising} work
 */
function showAnswer({ task, panel, easel, say, aim }) {
  const { asked, instrument } = task;
  const picking = asked === null && instrument !== null;
  setSeen(panel.listing.whole, picking);
  setSeen(panel.whole, picking && task.picking.isWhole(instrument, task.picks));
  const sides = asked !== null && hasSides(task, asked) ? (easel.steps.get(asked.it)?.sides ?? []) : [];
  panel.sides.forEach((one, k) => {
    setSeen(one, sides.length > 0);
    one.replaceChildren(sides[k] ?? "");
  });
  setSeen(panel.figure.form, asked !== null && aim === null && sides.length === 0);
  setSeen(panel.spot.form, aim !== null);
  if (aim !== null) panel.spot.show(aim);
  const distances = asked === null || aim === null ? [] : distancesFor(asked, easel, aim);
  panel.distances.replaceChildren(...distances.flatMap(([letters, mm]) => distanceOf(letters, mm, say("mm"))));
}

/**
 * Show what can be done with what was told last: let it stand though it is wrong, do it again; ask for help.
 * @param {Practising} work
 */
function showAfter({ task, panel, easel, say, now }) {
  const { asked } = task;
  const result = task.results.get(now) ?? null;
  const poor = result !== null && isPoor(result);
  setSeen(panel.leave, task.refused !== null);
  setSeen(panel.again, asked === null && poor);
  if (poor) panel.again.replaceChildren(...new Verdicts(easel, say).named("try again", now));
  panel.help.replaceChildren(say(`help ${task.stage}`));
  setSeen(panel.readings, !easel.task.pose); // no check knows a pose
  setSeen(panel.help, asked !== null || task.next !== null);
}

/**
 * @param {Element} part
 * @param {boolean} seen
 */
function setSeen(part, seen) {
  part.toggleAttribute("hidden", !seen);
}

/**
 * Return a figure that a step takes, as it was given or found.
 * @param {string} letter
 * @param {string} told with its unit; "" of what is no figure
 */
function dataOf(letter, told) {
  return told === "" || letter === "" ? [] : [element("span", { class: "piece" }, ...sentenceOf([letter]), ` = ${told}`), " "];
}

/**
 * @param {string} letters
 * @param {string} mm
 * @param {string} unit
 */
function distanceOf(letters, mm, unit) {
  return [element("span", { class: "piece" }, ...sentenceOf([letters]), ` ${mm} ${unit}`), " "];
}

/**
 * Return what is asked for now.
 * @param {Practising} work
 */
function promptOf({ task, easel, say, aim }) {
  const asked = task.asked;
  if (asked === null) {
    if (task.instrument !== null) return [say(`${task.instrument.name} takes`)];
    return [say(task.ready ? "all done" : "choose")];
  }
  const key = aim !== null ? "prick" : hasSides(task, asked) ? "which way" : READ_OFF.includes(asked.op) ? "read off" : "work out";
  const [before = "", after = ""] = filled(say(key), { letter: "{letter}", most: MISSED }).split("{letter}");
  return [before, ...sentenceOf([[easel.letterOf(asked.it), asked.it]]), after];
}

/** What is read off a ruler. */
const READ_OFF = ["measure", "measure_along"];

/**
 * Return the board as it stands.
 * @param {Practising} work
 * @returns {Omit<Shown, "taken">}
 */
function boardOf({ task, easel, session, aim, begun, now }) {
  const given = [...new Set([session.told.pole, ...session.told.shown])].filter((slot) => slot >= 0 && easel.isHere(slot));
  const done = [...task.own.values()].filter((move) => task.isDone(move.it));
  const slots = [...given, ...done.map((move) => move.it)];
  const isWrong = (/** @type {number} */ slot) => task.results.get(slot)?.verdict === "wrong" || task.results.get(slot)?.missed === true;
  return {
    frame: session.frame,
    shapes: shapesOf(slots, done, easel.values, session.frame),
    letterOf: (slot) => easel.letterOf(slot),
    arrows: session.mechanism !== undefined,
    picks: task.picks,
    fits: (slot) => task.fits(slot),
    now,
    wrong: isWrong,
    aim,
    moved: aim !== begun,
    ruler: task.asked === null ? null : rulerFor(task.asked, easel),
  };
}
