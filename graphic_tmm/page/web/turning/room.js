import { readable } from "../cards.js";
import { LEAP, runner, turningRange } from "../controls.js";
import { fixedText } from "../crank-values.js";
import { element, iconButton, typeset } from "../dom.js";
import { listenToKeys } from "../keys.js";
import { turningPicture } from "./bodies.js";
import { alongCourse, WHOLE_TURN, withinTurn } from "./courses.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Turning} Turning
 * @typedef {import("../types.js").TurningFigure} TurningFigure
 * @typedef {import("../state.js").State} State
 */

const BACK = "M6 5v14M19 5 9 12l10 7z";

/**
 * Build the way of looking in which cams and wheels turn; it is filled when it is looked at first.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function turningRoom(data, state) {
  const room = element("section", { id: "turning" });
  let begun = false;
  state.hear((place) => {
    if (place.tab !== "turning" || begun || data.turning === undefined) return;
    begun = true;
    fillTurning(room, data, data.turning, state);
    room.dataset["ready"] = "";
  });
  return room;
}

/**
 * @param {HTMLElement} room
 * @param {Data} data
 * @param {Turning} turning
 * @param {State} state
 */
function fillTurning(room, data, turning, state) {
  const say = (/** @type {string} */ key) => data.words[`turning ${key}`] ?? key;
  let turn = 0;
  const cards = turning.figures.map((figure) => turningCard(turning, figure));
  const { engine, parts } = runner(say, (by) => go(turn + by));
  const range = turningRange(say("angle"), { whole: WHOLE_TURN + 1 }, (to) => stand(turn - withinTurn(turn) + to));
  const angle = element("output", { class: "angle", "aria-live": "off" });
  const bar = element("div", { class: "bar" }, iconButton(BACK, say("start"), () => stand(0)), ...parts, angle, range);
  room.append(bar, element("div", { class: "cards" }, ...cards.map((card) => card.figure)));

  /** @param {number} to how far what drives has turned, degrees: what it drives needs more than one turn to come back */
  function go(to) {
    turn = to;
    for (const card of cards) card.show(turn);
    const told = `φ = ${fixedText(turn, 0, turning.decimal)}°`;
    angle.textContent = told;
    range.value = String(Math.round(withinTurn(turn)));
    range.setAttribute("aria-valuetext", told);
  }

  /** @param {number} to */
  function stand(to) {
    engine.run(false);
    go(to);
  }

  state.hear((place) => {
    if (place.tab !== "turning") engine.run(false);
  });
  const step = (/** @type {number} */ by) => () => stand(Math.round(turn) + by);
  listenToKeys(state, "turning", {
    ArrowRight: step(1),
    ArrowUp: step(1),
    ArrowLeft: step(-1),
    ArrowDown: step(-1),
    PageUp: step(LEAP),
    PageDown: step(-LEAP),
    0: () => stand(0),
    Home: () => room.scrollTo({ top: 0 }),
    End: () => room.scrollTo({ top: room.scrollHeight }),
    " ": () => engine.toggle(),
  });
  go(0);
}

/**
 * Return a picture with its title and what is told beside it.
 * @param {Turning} turning
 * @param {TurningFigure} figure
 */
function turningCard(turning, figure) {
  const { svg, show } = turningPicture(turning, figure);
  const cells = figure.values.map(([letter, unit, places, course]) => {
    const text = document.createTextNode("");
    const row = element("div", {}, element("dt", {}, ...typeset(letter), " = "), element("dd", {}, text, unit === "°" ? unit : ` ${unit}`));
    return { row, tell: (/** @type {number} */ turn) => (text.textContent = fixedText(alongCourse(course, turn), places, turning.decimal)) };
  });
  const caption = element("figcaption", {}, element("span", {}, ...typeset(figure.title)), element("small", {}, ...typeset(figure.caption)));
  const values = element("dl", { class: "values" }, ...cells.map((cell) => cell.row));
  const made = element("figure", { class: "card" }, svg, caption, values);
  svg.style.aspectRatio = figure.box.slice(2).join(" / ");
  readable({ svg });
  return {
    figure: made,
    /** @param {number} turn */
    show(turn) {
      show(turn);
      for (const cell of cells) cell.tell(turn);
    },
  };
}
