import { element, typeset } from "../dom.js";

/**
 * @typedef {import("./easel.js").Easel} Easel
 * @typedef {import("./task.js").Task} Task
 * @typedef {import("./listing.js").Group} Group
 * @typedef {(key: string) => string} Say
 */

/** In which groups marks are listed, by their kinds. @type {[string, string[]][]} */
const KINDS = [
  ["points", ["point"]],
  ["lines", ["line", "arc"]],
  ["values", ["length", "number", "angle"]],
];

/**
 * Return what an instrument may be laid to now, in groups: on the plan, of the mechanism, values.
 * @param {Task} task
 * @param {Easel} easel
 * @param {Say} say
 * @returns {Group[]}
 */
export function groupsFor(task, easel, say) {
  const known = [...new Set([...easel.task.shown, ...task.results.keys()])].sort((a, b) => a - b);
  const open = known.filter((slot) => (task.fits(slot) || task.picks.includes(slot)) && easel.value(slot) !== null);
  const items = (/** @type {(slot: number) => boolean} */ which) =>
    open.filter(which).map((slot) => ({ slot, letter: easel.letterOf(slot), told: easel.toldOf(slot), done: task.isDone(slot) }));
  const isFigure = (/** @type {number} */ slot) => KINDS[2]?.[1].includes(easel.kindOf(slot)) === true;
  const here = KINDS.map(([title, kinds]) => ({
    title: say(title),
    items: items((slot) => kinds.includes(easel.kindOf(slot)) && (isFigure(slot) || easel.isHere(slot))),
  }));
  const others = { title: say("on mechanism"), items: items((slot) => !isFigure(slot) && !easel.isHere(slot)) };
  return [...here.slice(0, 2), others, ...here.slice(2)];
}

/** So far below the pointer the question stands, px. */
const BELOW = 12;

/**
 * Ask which of several marks in one place is meant.
 * @param {HTMLElement} menu
 * @param {[number, number]} at px of the paper
 * @param {number[]} slots
 * @param {Easel} easel
 * @param {(slot: number) => void} pick
 */
export function menuOf(menu, [x, y], slots, easel, pick) {
  const buttons = [...slots].sort((a, b) => a - b).map((slot) => {
    const made = element("button", { type: "button" }, ...typeset(easel.letterOf(slot)));
    made.addEventListener("click", () => pick(slot));
    return made;
  });
  menu.replaceChildren(...buttons);
  const { clientWidth, clientHeight } = menu.parentElement ?? menu;
  const half = menu.offsetWidth / 2;
  menu.style.setProperty("left", `${Math.max(half, Math.min(x, clientWidth - half))}px`);
  menu.style.setProperty("top", `${Math.min(y, clientHeight - menu.offsetHeight - BELOW)}px`);
  buttons[0]?.focus({ preventScroll: true });
}
