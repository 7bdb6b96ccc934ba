import { turnAt } from "./dense.js";
import { element, iconButton, typeset } from "./dom.js";
import { motor, SPEEDS } from "./motor.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./cards.js").Card} Card
 * @typedef {(key: string) => string} Say
 * @typedef {ReturnType<typeof motor>} Motor
 */

const RUN = "M7 4v16l13-8z";
const HALT = "M7 5v14M16 5v14";
/** So many degrees a page up or down. */
export const LEAP = 30;

/**
 * Return the button that lets the crank turn by itself, the motor behind it, and the choice of its speed.
 * @param {Say} say
 * @param {(by: number) => void} turn
 */
export function runner(say, turn) {
  const run = iconButton(RUN, say("turn on"), () => engine.toggle());
  const engine = motor(turn, (runs) => {
    run.querySelector("path")?.setAttribute("d", runs ? HALT : RUN);
    run.setAttribute("aria-label", say(runs ? "turn off" : "turn on"));
    run.title = say(runs ? "turn off" : "turn on");
  });
  const speed = /** @type {HTMLSelectElement} */ (element("select", {}));
  speed.append(...SPEEDS.map((one, n) => element("option", { value: String(n) }, `${one} ${say("a second")}`)));
  speed.value = "1";
  speed.addEventListener("change", () => engine.shift(Number(speed.value)));
  return { engine, parts: [run, element("label", {}, `${say("speed")} `, speed)] };
}

/**
 * Return the range that turns the crank, for who has no pointer.
 * @param {string} name
 * @param {Pick<Dense, "whole">} dense
 * @param {(turn: number) => void} go
 */
export function turningRange(name, dense, go) {
  const most = dense.whole - 1;
  const made = /** @type {HTMLInputElement} */ (
    element("input", { type: "range", class: "turn", min: "0", max: String(most), step: "1", "aria-label": name })
  );
  made.addEventListener("input", () => go(Number(made.value)));
  made.addEventListener("keydown", (event) => {
    const by = { PageUp: LEAP, PageDown: -LEAP }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    go(Number(made.value) + by);
  });
  return made;
}

/**
 * Return a button for each position of the sheet.
 * @param {Dense} dense
 * @param {(turn: number) => void} go
 */
export function positionButtons(dense, go) {
  return dense.positions.map(([name, index]) => {
    const made = element("button", { type: "button" }, name);
    made.addEventListener("click", () => go(turnAt(dense, index)));
    return made;
  });
}

/**
 * Return the choice of what is seen; `chosen` follows it.
 * @param {string} name
 * @param {Card[]} cards
 * @param {Set<Card>} chosen
 * @param {() => void} show
 */
export function choices(name, cards, chosen, show) {
  const boxes = cards.map((card) => {
    const box = /** @type {HTMLInputElement} */ (element("input", { type: "checkbox" }));
    box.checked = chosen.has(card);
    card.figure.hidden = !box.checked;
    box.addEventListener("change", () => {
      card.figure.hidden = !box.checked;
      if (box.checked) chosen.add(card);
      else chosen.delete(card);
      show();
    });
    return element("label", {}, box, element("span", {}, ...typeset(card.title)));
  });
  return element("div", { class: "choices", role: "group", "aria-label": name }, ...boxes);
}
