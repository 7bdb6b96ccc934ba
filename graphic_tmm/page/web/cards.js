import { Cursors } from "./cursor.js";
import { element, iconButton, typeset } from "./dom.js";
import { growApart } from "./enlarge.js";
import { Moving } from "./moving.js";
import { placeOf } from "./strokes.js";
import { fixedText, fourFigures, NONE, Values } from "./crank-values.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").MovingFigure} MovingFigure
 * @typedef {{show: (k: number, drawn: boolean) => void, svg: SVGElement, box?: number[],
 *   enlarged?: (larger: number) => void, numbers?: import("./numbers.js").PutNumbers}} Shown
 * @typedef {{name: string, title: string, figure: HTMLElement, leads: MovingFigure | null,
 *   built: () => Shown, show: (k: number, drawn: boolean) => void}} Card
 */

/** What takes more over the turn has two columns, mm. */
const BROAD = 240;
/** Letters are told large enough to be read, px for a capital of 5 mm. */
const LEGIBLE = 13;
const CAPITAL = 5;
const LARGEST = 2.2;
/** At fewer px a millimetre lines are drawn broader. */
const SEEN = 2;
const FIT = "M10.5 4a6.5 6.5 0 1 0 .1 0M15 15l5 5M10.5 8v5M8 10.5h5";
/** White about a drawing that is fitted, mm. */
const ABOUT = 6;

/**
 * Return what moves with the crank, each as a card: figures, then the views of the sheets that bear cursors. A card is
 * built when it is shown first.
 * @param {Data} data
 * @param {Dense} dense
 * @param {Int32Array[]} packed
 * @param {import("./lengths.js").Lengths | null} lengths that can be changed
 * @returns {Card[]}
 */
export function cardsOf(data, dense, packed, lengths = null) {
  const figures = dense.figures.map((figure) => {
    const values = new Values(dense, figureValues(dense, figure, packed, lengths));
    const make = () => new Moving(dense, figure, packed, lengths?.ink ?? null);
    const made = card(figure.name, figure.title, figure.caption, figure.box, values, make, figure, data.words["fit now"]);
    return lengths === null ? made : captioned(made, figure, dense, lengths);
  });
  const ids = [...new Set(dense.cursors.map((one) => one.view))];
  const views = ids.flatMap((id) => {
    const view = data.views.find((one) => one.id === id);
    if (view === undefined) return [];
    const own = dense.cursors.filter((one) => one.view === id);
    /** @type {Float32Array[]} */
    const rows = [];
    for (const [n = 0, by] of own.flatMap((one) => [one.x, one.y])) {
      if (by !== undefined) rows[n] ??= Float32Array.from(packed[n] ?? [], (value) => value / 1000);
    }
    const told = own.filter((one) => one.letter !== "").map((one) => {
      const height = placeOf(one.y, rows);
      const mm = (/** @type {number} */ k) => Math.round(1000 * (one.origin - height(k))) / 1000;
      return {
        ...one,
        number: (/** @type {number} */ k) => fourFigures(mm(k) * one.mu, dense.decimal),
        live: (/** @type {number} */ k) => (lengths?.changed() === true ? shownCursors()?.told(own.indexOf(one), k) : undefined),
      };
    });
    const results = (dense.results ?? []).filter((one) => one.view === id).map((one) => ({
      ...one,
      texts: [],
      there: /** @type {0} */ (0),
      number: () => one.text,
      live: () => (lengths?.changed() === true ? resultText(lengths.mark(one.slot), dense.decimal) : undefined),
    }));
    /** @type {Cursors | null} */
    let made = null;
    const shownCursors = () => made;
    const make = () => (made = new Cursors(view, own, rows, lengths, dense.decimal));
    const letters = [...new Set(told.map((one) => one.letter))];
    const title = letters.length > 1 ? letters.join(", ") : view.title;
    return [card(id, title, "", view.box, new Values(dense, [...told, ...results]), make, null)];
  });
  return [...figures, ...views];
}

/**
 * @param {number} value
 * @param {string} decimal
 */
function resultText(value, decimal) {
  return Number.isFinite(value) ? fourFigures(value, decimal) : NONE;
}

/**
 * @param {Dense} dense
 * @param {MovingFigure} figure
 * @param {Int32Array[]} packed
 * @param {import("./lengths.js").Lengths | null} lengths
 */
function figureValues(dense, figure, packed, lengths) {
  return figure.values.map((value) => {
    const [n = 0, by] = value.row;
    const { log } = value;
    const own = (/** @type {number} */ k) => {
      if (log !== undefined) return lengths?.number(log, k) ?? NaN;
      return (by === undefined ? n : (packed[n]?.[k] ?? 0)) * value.worth;
    };
    // what never changes is told as at the positions
    const still = by === undefined && log === undefined ? value.texts.find((text) => text !== null) : undefined;
    const text = (/** @type {number} */ number) => (Number.isFinite(number) ? fixedText(number, value.places, dense.decimal) : NONE);
    return {
      ...value,
      number: (/** @type {number} */ k) => still ?? text(own(k)),
      live(/** @type {number} */ k) {
        if (lengths === null || !lengths.changed()) return undefined;
        return log === undefined ? null : text(own(k));
      },
    };
  });
}

/**
 * @param {string} name
 * @param {string} title
 * @param {string} caption
 * @param {number[]} box
 * @param {Values} values
 * @param {() => Shown} make
 * @param {MovingFigure | null} own
 * @param {string} fit what the button is called that fits the drawing to the present angle
 * @returns {Card}
 */
function card(name, title, caption, box, values, make, own, fit = "") {
  const heading = element("figcaption", {}, element("span", {}, ...typeset(title)), element("small", {}, ...typeset(caption)));
  const figure = element("figure", { class: "card" }, heading, values.list);
  const [, , width = 1, height = 1] = box;
  figure.classList.toggle("wide", width > BROAD);
  /** @type {Shown | null} */
  let shown = null;
  const built = () => {
    if (shown === null) {
      shown = make();
      figure.prepend(shown.svg);
      shown.svg.style.aspectRatio = `${width} / ${height}`;
      readable(shown);
      if (own !== null) heading.append(fitting(shown, box, fit));
    }
    return shown;
  };
  return {
    name,
    title,
    figure,
    leads: own?.crank === undefined ? null : own,
    built,
    show(k, drawn) {
      built().show(k, drawn);
      values.show(k, drawn);
    },
  };
}

/**
 * Let the caption of a card tell the scale factor that its figure is drawn to.
 * @param {Card} made
 * @param {MovingFigure} figure
 * @param {Dense} dense
 * @param {import("./lengths.js").Lengths} lengths
 * @returns {Card}
 */
function captioned(made, figure, dense, lengths) {
  const caption = made.figure.querySelector("figcaption small");
  let told = figure.caption;
  return {
    ...made,
    show(k, drawn) {
      made.show(k, drawn);
      const mu = lengths.scale(figure.name, k);
      const now = Number.isFinite(mu) ? figure.caption.replace(/(?<== )\S+/, fourFigures(mu, dense.decimal)) : figure.caption;
      if (now !== told) caption?.replaceChildren(...typeset((told = now)));
    },
  };
}

/**
 * Return the button that shows the present drawing as large as there is room, or the room of the whole turn again.
 * @param {Shown} shown
 * @param {number[]} box of the whole turn
 * @param {string} name
 */
function fitting(shown, box, name) {
  const { svg } = shown;
  const whole = () => shown.box ?? box;
  const made = iconButton(FIT, name, () => {
    const fits = made.getAttribute("aria-pressed") !== "true";
    made.setAttribute("aria-pressed", String(fits));
    const body = /** @type {SVGGraphicsElement | null} */ (svg.querySelector(".body"));
    const now = body?.getBBox();
    const close = now === undefined ? whole() : [now.x - ABOUT, now.y - ABOUT, now.width + 2 * ABOUT, now.height + 2 * ABOUT];
    svg.setAttribute("viewBox", (fits ? close : whole()).join(" "));
    weigh(shown);
  });
  svg.addEventListener("settled", () => {
    svg.setAttribute("viewBox", whole().join(" "));
    made.setAttribute("aria-pressed", "false");
    weigh(shown);
  });
  made.setAttribute("aria-pressed", "false");
  return made;
}

/**
 * Let the letters of a drawing be read where it is small.
 * @param {Pick<Shown, "svg" | "enlarged">} shown
 */
export function readable(shown) {
  new ResizeObserver(() => weigh(shown)).observe(shown.svg);
}

/** @param {Pick<Shown, "svg" | "enlarged">} shown */
function weigh(shown) {
  const { svg } = shown;
  const { width, height } = svg.getBoundingClientRect();
  const [, , across = 1, up = 1] = (svg.getAttribute("viewBox") ?? "").split(" ").map(Number);
  const scale = Math.min(width / across, height / up);
  if (!(scale > 0)) return;
  const larger = Math.min(LARGEST, Math.max(1, LEGIBLE / (CAPITAL * scale)));
  svg.style.setProperty("--larger", larger.toFixed(2));
  shown.enlarged?.(larger);
  const still = /** @type {SVGElement[]} */ ([...svg.querySelectorAll(".stays .glyph")]);
  growApart(svg, still, still.map(() => larger), "--larger");
  svg.style.setProperty("--heavier", Math.max(1, SEEN / scale).toFixed(2));
  svg.dispatchEvent(new Event("weighed"));
}
