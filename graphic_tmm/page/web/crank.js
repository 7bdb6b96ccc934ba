import { cardsOf } from "./cards.js";
import { bytesOf } from "./data.js";
import { indexAt, turnAt, turnWithin, whyNot } from "./dense.js";
import { element, filled, typeset } from "./dom.js";
import { putHandle } from "./handle.js";
import { listenToKeys } from "./keys.js";
import { LENGTHS } from "./lengths.js";
import { unpackedRows } from "./pack.js";
import { choices, LEAP, positionButtons, runner, turningRange } from "./controls.js";
import { placeText } from "./crank-values.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./cards.js").Card} Card
 * @typedef {import("./state.js").State} State
 */

/** So many figures are seen at first: the mechanism and its plans. */
const FIRST = 3;

/**
 * Build the way of looking in which the crank is turned; it is filled when it is looked at first.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function crankRoom(data, state) {
  const room = element("section", { id: "crank" });
  let begun = false;
  state.hear((place) => {
    if (place.tab !== "crank" || begun || data.crank === undefined) return;
    begun = true;
    const dense = data.crank;
    bytesOf("crank-rows").then((bytes) => {
      fill(room, data, dense, state, unpackedRows(bytes, dense.lengths));
      room.dataset["ready"] = "";
    });
  });
  return room;
}

/**
 * @param {HTMLElement} room
 * @param {Data} data
 * @param {Dense} dense
 * @param {State} state
 * @param {Int32Array[]} packed
 */
function fill(room, data, dense, state, packed) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const lengths = LENGTHS.begin?.(data, dense, show) ?? null;
  const cards = cardsOf(data, dense, packed, lengths);
  const chosen = new Set(cards.slice(0, FIRST));
  const { engine, parts } = runner(say, run);
  const range = turningRange(say("angle"), dense, stand);
  const angle = /** @type {HTMLOutputElement} */ (element("output", { class: "angle", "aria-live": "off" }));
  const why = element("p", { class: "why", role: "status" });
  const positions = positionButtons(dense, stand);
  const choice = choices(say("shown"), cards, chosen, show);
  const bar = element("div", { class: "bar" }, ...parts, angle, range);
  const row = element("div", { class: "row", role: "group", "aria-label": say("position") }, ...positions);
  const grid = element("div", { class: "cards" }, choice);
  const beside = element("div", { class: "stand" });
  for (const card of cards) (card.leads ? beside : grid).append(card.figure);
  const seen = watched(cards, show);
  beside.append(element("div", { class: "tools" }, bar, row, ...(lengths === null ? [] : [lengths.panel])));
  room.append(beside, grid);
  /** @type {(turn: number, pin?: import("./types.js").Complex | null) => void} */
  let hold = () => {};
  const lead = cards.find((card) => card.leads !== null);
  if (lead?.leads) {
    lead.figure.classList.add("lead");
    if (lead.leads.crank?.length) hold = putHandle(dense, lead.leads, lead.built().svg, () => state.place.turn, stand);
    lengths?.lead(lead.built().svg, lead.built().numbers);
    lead.figure.append(why);
  }

  /** @param {number} turn */
  function go(turn) {
    state.go({ turn: turnWithin(dense, turn) });
  }

  /**
   * Go on by so many steps; from the end of a row that has one begin anew, and stand there.
   * @param {number} by
   */
  function run(by) {
    const last = dense.whole - 1;
    if (dense.ends === undefined) return go(state.place.turn + by);
    go(state.place.turn >= last ? 0 : state.place.turn + by);
    if (state.place.turn >= last) engine.run(false);
  }

  /**
   * Go to an angle, and stand there.
   * @param {number} turn
   */
  function stand(turn) {
    engine.run(false);
    go(turn);
  }

  function show() {
    const k = indexAt(dense, state.place.turn);
    const reason = lengths?.why(k) ?? whyNot(dense, k);
    for (const card of cards) if (chosen.has(card) && seen.has(card)) card.show(k, reason === "");
    hold(turnAt(dense, k), lengths?.pin(k));
    lengths?.stand(k);
    range.value = String(Math.round(turnAt(dense, k)));
    const name = dense.positions.find(([, index]) => index === k)?.[0];
    const place = `${placeText(dense, k)}${name === undefined ? "" : `, ${say("position").toLowerCase()} ${name}`}`;
    angle.replaceChildren(...typeset(place));
    range.setAttribute("aria-valuetext", place.replace(/[_{}]/g, ""));
    const told = reason === "" ? "" : filled(say("not drawn"), { why: reason });
    if (why.textContent !== told) why.textContent = told;
    positions.forEach((one, n) => one.setAttribute("aria-pressed", String(dense.positions[n]?.[1] === k)));
  }

  state.hear((place) => {
    if (place.tab === "crank") show();
    else engine.run(false);
  });
  lengths?.again();
  const step = (/** @type {number} */ by) => () => stand(Math.round(state.place.turn) + by);
  listenToKeys(state, "crank", {
    ArrowRight: step(1),
    ArrowUp: step(1),
    ArrowLeft: step(-1),
    ArrowDown: step(-1),
    PageUp: step(LEAP),
    PageDown: step(-LEAP),
    Home: () => room.scrollTo({ top: 0 }),
    End: () => room.scrollTo({ top: room.scrollHeight }),
    " ": () => engine.toggle(),
  });
}

/**
 * Return which cards stand in the window, kept as they come and go: what nobody sees is not drawn.
 * @param {Card[]} cards
 * @param {() => void} show
 */
function watched(cards, show) {
  const seen = new Set(cards.slice(0, FIRST));
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const card = cards.find((one) => one.figure === entry.target);
      if (card === undefined) continue;
      if (entry.isIntersecting) seen.add(card);
      else seen.delete(card);
    }
    show();
  });
  for (const card of cards) observer.observe(card.figure);
  return seen;
}
