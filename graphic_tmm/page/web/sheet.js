import { element, filled, iconButton } from "./dom.js";
import { listenToKeys } from "./keys.js";
import { allLayers, layersPanel, shownInk } from "./layers.js";
import { printSheet, printTiles } from "./print.js";
import { Desk } from "./sheet-desk.js";
import { keysOfSheet, listenToHands } from "./sheet-gestures.js";
import { inkOf } from "./sheet-ink.js";
import { percent, ScreenSize } from "./sheet-size.js";
import { sameMark, toldOf } from "./sheet-told.js";

/**
 * @typedef {import("./sheet-ink.js").SheetInk} SheetInk
 * @typedef {import("./sheet-ink.js").SheetView} SheetView
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

const TAB = "sheets";
const ICONS_OF_SHEET = {
  less: "M5 12h14",
  more: "M5 12h14M12 5v14",
};
/** How near ink is pointed at, px: by a mouse, by a finger. */
const REACH = 4;
const FINGER = 12;
/** A view fills the screen when it is shown so large, as a share of the largest. */
const FILLED = 0.75;
/** Where a millimetre is smaller, px, a finger points at a view and not at its ink. */
const FINE = 1.5;

/**
 * Build the way of looking in which sheets lie at true scale.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function sheetRoom(data, state) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const room = /** @type {HTMLElement} */ (document.getElementById(TAB));
  const svgs = [...room.querySelectorAll("figure.sheet > svg")];
  const played = new Map(data.views.map((view) => [view.id, view]));
  const size = new ScreenSize();
  const layers = allLayers();
  /** @type {Map<number, SheetInk>} */
  const read = new Map();
  let number = -1;
  let from = -1;
  /** @type {import("./sheet-ink.js").Ink | undefined} */
  let pointed;

  const surface = element("div", { class: "desk", tabindex: "0", role: "application", "aria-label": say("desk keys") });
  const desk = new Desk(surface, (view) => played.get(view.id)?.position ?? "");
  const told = element("p", { class: "told" }, say("desk"));
  const scale = element("span", { class: "count" });
  const choice = element("div", { class: "choice" });
  const list = element("ol", { class: "views", "aria-label": say("views") });
  const chooser = /** @type {HTMLSelectElement} */ (element("select", {}));
  chooser.append(...data.sheets.map((one, k) => element("option", { value: String(k) }, `${k + 1} · ${one.format.split(" ")[0]}`)));
  chooser.addEventListener("change", () => lay(Number(chooser.value)));
  desk.onDrawn = () => {
    const factor = desk.camera.zoom / size.millimetre;
    scale.textContent = filled(say("true size"), { percent: percent(factor, data.language) });
  };

  const keys = keysOfSheet(() => desk.camera, () => size.millimetre, () => desk.moved());
  const act = (/** @type {string} */ key) => () => keys[key]?.();
  const bar = element(
    "div",
    { class: "bar", role: "toolbar", "aria-label": say("size") },
    element("label", {}, `${say("sheet")} `, chooser),
    textButton(say("fit sheet"), say("fit whole"), act("0")),
    textButton("1 : 1", say("fit true"), act("1")),
    iconButton(ICONS_OF_SHEET.less, say("smaller"), act("-")),
    iconButton(ICONS_OF_SHEET.more, say("larger"), act("+")),
    scale,
  );
  const printer = element(
    "details",
    {},
    element("summary", {}, say("print")),
    textButton(say("print sheet"), "", () => printSheet(data, number)),
    textButton(say("print tiles"), "", () => printTiles(data, number)),
    element("p", {}, say("print check")),
  );
  const panel = element("div", { class: "panel" }, choice, printer, size.panel(data, () => desk.moved()), list);

  /** @param {number} k */
  function lay(k) {
    const svg = svgs[k];
    const shape = data.sheets[k];
    if (svg === undefined || shape === undefined) return;
    number = k;
    chooser.value = String(k);
    const sheet = read.get(k) ?? inkOf(svg, shape);
    read.set(k, sheet);
    desk.lay(sheet);
    choice.replaceChildren(layersPanel(data, sheet, layers, played, show));
    list.replaceChildren(...sheet.views.filter((view) => !view.frame).map(entry));
    told.replaceChildren(say("desk"));
    show();
  }
  function show() {
    desk.show(shownInk(desk.sheet, layers, played), layers.large);
    desk.moved();
  }
  /** @param {SheetView} view */
  function entry(view) {
    const made = textButton(view.title, "", () => (played.has(view.id) ? play(view) : fill(view)));
    made.addEventListener("focus", () => choose(view));
    return element("li", {}, made);
  }
  /** @param {SheetView | null} view */
  function choose(view) {
    desk.chosen = view;
    desk.moved();
  }
  /** @param {SheetView} view */
  function play(view) {
    const found = data.views.findIndex((one) => one.id === view.id);
    if (found >= 0) state.go({ tab: "play", view: found });
  }
  /** @param {HTMLElement[]} inner */
  function tell(inner) {
    told.replaceChildren(...inner);
    const live = document.getElementById("live");
    const said = inner.flatMap((one) => (one.localName === "button" ? [] : [one.textContent]));
    if (live !== null) live.textContent = said.join(" ");
  }
  /** @param {SheetView} view */
  function fill(view) {
    choose(view);
    desk.glideTo(view.box);
    const way = played.has(view.id) ? [textButton(say("play view"), "", () => play(view))] : [];
    tell([element("b", {}, view.title), ...way]);
  }
  /**
   * @param {number} px
   * @param {number} py
   * @param {boolean} touch
   */
  function tap(px, py, touch) {
    const there = touch && desk.camera.zoom < FINE ? [] : desk.inkAt(px, py, touch ? FINGER : REACH);
    // what lies upon each other is told in turn
    const ink = there[(there.findIndex((one) => one === pointed) + 1) % there.length];
    pointed = ink;
    if (ink !== undefined) {
      const ofView = (/** @type {number} */ k) => played.get(desk.sheet.views[k]?.id ?? "");
      desk.chosen = null;
      desk.lit = sameMark(ink, desk.shown, (k) => ofView(k)?.board ?? "");
      tell(toldOf(ink, desk.sheet, data, ofView(ink.view), state));
      return desk.moved();
    }
    desk.lit = [];
    const view = desk.viewAt(px, py);
    if (view === undefined) return choose(null);
    const largest = desk.camera.zoomFor(view.box[2] - view.box[0], view.box[3] - view.box[1]);
    if (desk.camera.zoom >= FILLED * largest && played.has(view.id)) play(view);
    else fill(view);
  }
  listenToHands(surface, () => desk.camera, () => desk.moved(), tap);
  listenToKeys(state, TAB, { ...keys, Enter: () => desk.chosen !== null && play(desk.chosen) });
  state.hear((place) => {
    if (place.tab !== TAB || (number >= 0 && place.view === from)) return;
    const view = data.views[place.view];
    if (number < 0 || (view !== undefined && view.sheet !== number)) lay(view?.sheet ?? 0);
    from = place.view;
    choose(desk.sheet.views.find((one) => one.id === view?.id) ?? null);
  });
  room.prepend(bar, surface, told, panel);
  return room;
}

/**
 * @param {string} name
 * @param {string} title
 * @param {() => void} act
 */
function textButton(name, title, act) {
  const made = element("button", { type: "button" }, name);
  if (title !== "") made.title = title;
  made.addEventListener("click", act);
  return made;
}
