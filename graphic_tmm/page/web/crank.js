import { Cursors } from "./cursor.js";
import { bytesOf } from "./data.js";
import { indexAt, turnAt, whyNot } from "./dense.js";
import { element, filled, iconButton, typeset } from "./dom.js";
import { putHandle } from "./handle.js";
import { listenToKeys } from "./keys.js";
import { motor, SPEEDS } from "./motor.js";
import { Moving } from "./moving.js";
import { unpackedRows } from "./pack.js";
import { placeOf } from "./strokes.js";
import { fixedText, fourFigures, Values } from "./crank-values.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./state.js").State} State
 * @typedef {{name: string, title: string, caption: string, svg: SVGElement, values: Values,
 *   show: (k: number, drawn: boolean) => void}} Card
 */

const RUN = "M7 4v16l13-8z";
const HALT = "M7 5v14M16 5v14";
/** So many figures are seen at first: the mechanism and its plans. */
const FIRST = 3;
const LEAP = 30;

/**
 * Build the way of looking in which the crank is turned; its figures are made when it is looked at first.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function crankRoom(data, state) {
  const room = element("section", { id: "crank" });
  const dense = data.crank;
  if (dense === undefined) return room;
  let begun = false;
  state.hear((place) => {
    if (place.tab !== "crank" || begun) return;
    begun = true;
    bytesOf("crank-rows").then((bytes) => fill(room, data, dense, state, bytes));
  });
  return room;
}

/**
 * @param {HTMLElement} room
 * @param {Data} data
 * @param {Dense} dense
 * @param {State} state
 * @param {ArrayBuffer} bytes
 */
function fill(room, data, dense, state, bytes) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const cards = cardsOf(data, dense, unpackedRows(bytes, dense.lengths));
  const chosen = new Set(cards.slice(0, FIRST).map((card) => card.name));
  const turn = () => state.place.turn;
  const go = (/** @type {number} */ to) => state.go({ turn: withinTurn(dense, to) });
  const degree = () => Math.round(turn());

  const run = iconButton(RUN, say("turn on"), () => engine.toggle());
  const engine = motor(
    (by) => go(turn() + by),
    (runs) => {
      run.querySelector("path")?.setAttribute("d", runs ? HALT : RUN);
      run.setAttribute("aria-label", say(runs ? "turn off" : "turn on"));
      run.title = say(runs ? "turn off" : "turn on");
    },
  );
  const range = slider(say("angle"), dense, (to) => {
    engine.run(false);
    go(to);
  });
  const angle = /** @type {HTMLOutputElement} */ (element("output", { class: "angle" }));
  const why = element("p", { class: "why", role: "status" });
  const positions = dense.positions.map(([name, index]) => {
    const made = element("button", { type: "button" }, name);
    made.addEventListener("click", () => {
      engine.run(false);
      go(turnAt(dense, index));
    });
    return made;
  });
  const bar = element("div", { class: "bar", role: "toolbar", "aria-label": say("crank") }, run, speeds(say, engine), angle);
  const row = element("div", { class: "row", role: "group", "aria-label": say("position") }, `${say("position")} `, ...positions);
  const grid = element("div", { class: "cards" });
  const choices = element("fieldset", { class: "choices" }, element("legend", {}, say("shown")));
  for (const card of cards) {
    const figure = element("figure", { class: "card" }, card.svg, element("figcaption", {}, card.title, element("small", {}, ...typeset(card.caption))), card.values.list);
    figure.hidden = !chosen.has(card.name);
    const box = /** @type {HTMLInputElement} */ (element("input", { type: "checkbox" }));
    box.checked = chosen.has(card.name);
    box.addEventListener("change", () => {
      figure.hidden = !box.checked;
      if (box.checked) chosen.add(card.name);
      else chosen.delete(card.name);
      show();
    });
    choices.append(element("label", {}, box, ` ${card.title}`));
    grid.append(figure);
  }
  const leads = dense.figures.findIndex((figure) => figure.crank !== undefined);
  const lead = cards[leads];
  const figure = dense.figures[leads];
  const stand =
    lead === undefined || figure === undefined
      ? () => {}
      : putHandle(dense, figure, lead.svg, turn, (to) => {
          engine.run(false);
          go(to);
        });
  lead?.svg.closest("figure")?.classList.add("lead");
  room.append(bar, range, row, why, grid, choices);

  function show() {
    const k = indexAt(dense, turn());
    const reason = whyNot(dense, k);
    for (const card of cards) if (chosen.has(card.name)) card.show(k, reason === "");
    stand(turnAt(dense, k));
    range.value = String(Math.min(degree(), Number(range.max)));
    const direction = ((((dense.zero + dense.sense * turnAt(dense, k)) % 360) + 360) % 360);
    const name = dense.positions.find(([, index]) => index === k)?.[0];
    const at = name === undefined ? "" : `, ${say("position").toLowerCase()} ${name}`;
    angle.value = `φ = ${fourFigures(Number(direction.toFixed(3)), dense.decimal)}°${at}`;
    range.setAttribute("aria-valuetext", angle.value);
    const told = reason === "" ? "" : filled(say("not drawn"), { why: reason });
    if (why.textContent !== told) why.textContent = told;
    positions.forEach((one, n) => one.setAttribute("aria-pressed", String(dense.positions[n]?.[1] === k)));
  }
  state.hear((place) => {
    if (place.tab === "crank") show();
    else engine.run(false);
  });
  const step = (/** @type {number} */ by) => () => {
    engine.run(false);
    go(degree() + by);
  };
  listenToKeys(state, "crank", {
    ArrowRight: step(1),
    ArrowUp: step(1),
    ArrowLeft: step(-1),
    ArrowDown: step(-1),
    PageUp: step(LEAP),
    PageDown: step(-LEAP),
    Home: () => go(0),
    End: () => go(dense.whole - 1),
    " ": () => engine.toggle(),
  });
}

/**
 * @param {Dense} dense
 * @param {number} turn
 */
function withinTurn(dense, turn) {
  return ((turn % dense.whole) + dense.whole) % dense.whole;
}

/**
 * Return the range that turns the crank, for who has no pointer.
 * @param {string} name
 * @param {Dense} dense
 * @param {(turn: number) => void} go
 */
function slider(name, dense, go) {
  const made = /** @type {HTMLInputElement} */ (
    element("input", { type: "range", class: "turn", min: "0", max: String(dense.whole - 1), step: "1", "aria-label": name })
  );
  made.addEventListener("input", () => go(Number(made.value)));
  made.addEventListener("keydown", (event) => {
    const by = { PageUp: LEAP, PageDown: -LEAP }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    go(withinTurn(dense, Number(made.value) + by));
  });
  return made;
}

/**
 * @param {(key: string) => string} say
 * @param {{shift: (n: number) => void}} engine
 */
function speeds(say, engine) {
  const made = /** @type {HTMLSelectElement} */ (element("select", {}));
  made.append(...SPEEDS.map((speed, n) => element("option", { value: String(n) }, `${speed} ${say("a second")}`)));
  made.value = "1";
  made.addEventListener("change", () => engine.shift(Number(made.value)));
  return element("label", {}, `${say("speed")} `, made);
}

/**
 * Return the figures that move, then the views with cursors.
 * @param {Data} data
 * @param {Dense} dense
 * @param {Int32Array[]} packed
 * @returns {Card[]}
 */
function cardsOf(data, dense, packed) {
  /** @type {Map<number, Float32Array>} */
  const plain = new Map();
  const row = (/** @type {number} */ n) => {
    const found = plain.get(n) ?? Float32Array.from(packed[n] ?? [], (value) => value / 1000);
    plain.set(n, found);
    return found;
  };
  const figures = dense.figures.map((figure) => {
    const values = new Values(
      dense,
      figure.values.map((value) => {
        const [n = 0, by] = value.row;
        const own = (/** @type {number} */ k) => (by === undefined ? n : (packed[n]?.[k] ?? 0)) * value.worth;
        return { ...value, number: (k) => fixedText(own(k), value.places, dense.decimal) };
      }),
    );
    /** @type {Moving | null} */
    let moving = null;
    const built = () => (moving ??= new Moving(dense, figure, packed));
    return {
      name: figure.name,
      title: figure.title,
      caption: figure.caption,
      svg: built().svg,
      values,
      show(/** @type {number} */ k, /** @type {boolean} */ drawn) {
        built().show(k, drawn);
        values.show(k, drawn);
      },
    };
  });
  const views = [...new Set(dense.cursors.map((one) => one.view))].flatMap((id) => {
    const view = data.views.find((one) => one.id === id);
    if (view === undefined) return [];
    const own = dense.cursors.filter((one) => one.view === id);
    const rows = own.flatMap((one) => [one.x, one.y]).filter((told) => told.length > 1);
    /** @type {Float32Array[]} */
    const among = [];
    for (const [n = 0] of rows) among[n] = row(n);
    const cursors = new Cursors(view, own, among);
    const values = new Values(
      dense,
      own
        .filter((one) => one.letter !== "")
        .map((one) => {
          const height = placeOf(one.y, among);
          return { ...one, number: (k) => fourFigures((one.origin - height(k)) * one.mu, dense.decimal) };
        }),
    );
    return [
      {
        name: id,
        title: view.title,
        caption: "",
        svg: cursors.svg,
        values,
        show(/** @type {number} */ k, /** @type {boolean} */ drawn) {
          cursors.show(k, drawn);
          values.show(k, drawn);
        },
      },
    ];
  });
  return [...figures, ...views];
}
