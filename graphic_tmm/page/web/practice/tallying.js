import { element, filled, sentenceOf } from "../dom.js";
import { isPoor } from "./verdicts.js";

/**
 * @typedef {import("./task.js").Task} Task
 * @typedef {import("./easel.js").Easel} Easel
 * @typedef {(key: string) => string} Say
 */

/** How a step that is done is told by a sign, and what that means. */
const WORTH = { once: "●", helped: "◐", shown: "○", wrong: "✗", left: "·" };
const MEANS = { once: "at once", helped: "helped", shown: "was shown", wrong: "was wrong" };

/**
 * Return the score in words and signs, and what is done, each to be done again.
 * @param {Say} say
 * @param {(slot: number) => void} redo
 */
export function tallying(say, redo) {
  const words = element("p", { class: "score" });
  const signs = element("p", { class: "signs", "aria-hidden": "true" });
  const list = element("ol", {});
  const head = element("summary", {}, say("done steps"));
  const whole = element("div", { class: "tally" }, words, signs, element("details", {}, head, list));
  return {
    whole,
    /**
     * @param {Task} task
     * @param {Easel} easel
     */
    show(task, easel) {
      const tally = task.score.tally();
      words.textContent = filled(say("score"), { ...tally, done: task.results.size });
      const marks = [...task.results.keys()].map((slot) => task.score.marks.get(slot) ?? "helped");
      signs.textContent = marks.map((mark) => WORTH[mark]).join("") + WORTH.left.repeat(Math.max(task.score.count - marks.length, 0));
      head.parentElement?.toggleAttribute("hidden", marks.length === 0);
      list.replaceChildren(...[...task.results.keys()].map((slot) => doneRow(say, task, easel, slot, redo)));
    },
  };
}

/**
 * @param {Say} say
 * @param {Task} task
 * @param {Easel} easel
 * @param {number} slot
 * @param {(slot: number) => void} redo
 */
function doneRow(say, task, easel, slot, redo) {
  const mark = task.score.marks.get(slot) ?? "helped";
  const result = task.results.get(slot) ?? null;
  const told = easel.toldOf(slot);
  const name = sentenceOf([[easel.letterOf(slot), slot]]);
  const sign = element("span", { class: "sign", role: "img", "aria-label": say(MEANS[mark]) }, WORTH[mark]);
  const inner = [sign, " ", ...name, ...(told === "" ? [] : [` = ${told}`])];
  if (result !== null && isPoor(result)) inner.push(" – ", element("span", { class: "poor" }, say(result.missed ? "missed" : result.verdict)));
  const move = task.own.get(slot);
  if (move === undefined || !task.isTold(move)) return element("li", { "data-of": String(slot) }, ...inner);
  const again = element("button", { type: "button", class: "again" }, ...inner);
  const [before = "", after = ""] = say("try again").split("{letter}");
  again.title = `${before}${easel.markOf(slot).n}${after}`;
  again.addEventListener("click", () => redo(slot));
  return element("li", { "data-of": String(slot) }, again);
}
