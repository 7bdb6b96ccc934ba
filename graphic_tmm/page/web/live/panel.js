import { element, filled, typeset } from "../dom.js";
import { tomlOf } from "./toml.js";

/**
 * @typedef {import("../types.js").Slider} Slider
 * @typedef {(values: Map<Slider, number>, last: Slider | null) => boolean} Take
 */

/** A range goes to so many times what is given, both ways from it. */
const REACHED = 0.75;
/** What is nothing may become so large a share of the largest of its unit. */
const OF_LARGEST = 0.5;
/** So many steps a range has. */
const STEPS = 400;
/** By so many of them keys go. @type {Record<string, number>} */
const RANGE_KEYS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/**
 * Return the panel of what can be changed: for each letter a range and a field, "as given", "copy as TOML".
 * @param {Slider[]} sliders
 * @param {Record<string, string>} words
 * @param {string} decimal
 * @param {Take} take
 * @param {(values: Map<Slider, number>) => void} release takes notice that nothing is being changed any more
 */
export function lengthsPanel(sliders, words, decimal, take, release) {
  /** @type {Map<Slider, number>} */
  const values = new Map();
  const say = (/** @type {string} */ key) => words[key] ?? key;
  // how it is done, until there is something else to say, stands in its place: nothing moves
  const told = element("p", { class: "told", role: "status" }, say("how changed"));
  const acts = { change, release: () => release(values), refuse: (/** @type {string} */ text) => say_(filled(say("given no number"), { text })) };
  const rows = sliders.map((slider) => givenRow(slider, reachOf(slider, sliders), decimal, filled(say("value of"), { letter: slider.n }), acts));
  const [given, copy] = [button(say("as given"), restore), button(say("copy keys"), copied)];
  const put = button(say("put keys"), () => document.dispatchEvent(new CustomEvent("own values", { detail: keysNow() })));
  put.className = "put";
  put.disabled = copy.disabled = true;
  document.addEventListener("own values left", again);
  document.addEventListener("own values put", (event) => say_(String(/** @type {CustomEvent} */ (event).detail)));
  const text = /** @type {HTMLTextAreaElement} */ (element("textarea", { class: "keys", readonly: "", hidden: "", "aria-label": "TOML", rows: "6" }));
  const list = element("div", { class: "givens" }, ...rows.map((row) => row.element));
  const made = /** @type {HTMLDetailsElement} */ (element("details", { class: "lengths" }, element("summary", {}, say("givens")), told, list, element("div", { class: "bar" }, given, copy, put), text));
  made.addEventListener("toggle", leave);

  /**
   * @param {Slider} slider
   * @param {number} value
   */
  function change(slider, value) {
    changeAll(new Map([[slider, value]]));
  }

  /** @param {Map<Slider, number>} some values */
  function changeAll(some) {
    const before = new Map(values);
    for (const [slider, value] of some) {
      if (value === slider.v) values.delete(slider);
      else values.set(slider, value);
    }
    const taken = take(values, [...some.keys()].at(-1) ?? null);
    for (const [slider, value] of some) rows[sliders.indexOf(slider)]?.set(value, !taken);
    if (!taken) {
      values.clear();
      for (const [one, held] of before) values.set(one, held);
    }
    put.disabled = copy.disabled = values.size === 0;
    leave();
  }

  /** Leave whether it is open, and what is not as given, to the page that may be put in this one's place. */
  function leave() {
    const own = [...values].map(([slider, value]) => [sliderName(slider), slider.v, value]);
    document.documentElement.dataset["own"] = JSON.stringify([made.open, own]);
  }

  /** Take what the page before this one left, of what the scene still gives as it did then. */
  function again() {
    const [open, own] = JSON.parse(document.documentElement.dataset["own"] ?? "[false, []]");
    const kept = own.flatMap((/** @type {[string, number, number]} */ [name, before, value]) =>
      sliders.filter((one) => sliderName(one) === name && one.v === before).map((one) => [one, value]),
    );
    made.open = open;
    if (kept.length === 0) return;
    changeAll(new Map(kept));
    release(values);
  }

  function restore() {
    values.clear();
    take(values, null);
    rows.forEach((row, n) => row.set(sliders[n]?.v ?? 0, false));
    text.hidden = put.disabled = copy.disabled = true;
    leave();
  }

  function keysNow() {
    return tomlOf(sliders, values, say("of several"));
  }

  function copied() {
    text.value = keysNow();
    text.hidden = false;
    text.select();
    const sayOf = (/** @type {boolean} */ there) => (there ? say_(say("copied")) : undefined);
    // within another page, and on a disk, a browser may refuse the one and allow the other
    navigator.clipboard?.writeText(text.value).then(() => sayOf(true), () => sayOf(document.execCommand("copy")));
  }

  /** @param {string} sentence */
  function say_(sentence) {
    const says = sentence || say("how changed");
    if (told.textContent !== says) told.replaceChildren(...typeset(says));
  }

  /** @param {Map<number, number>} lengths by slots, as they are dragged */
  function drag(lengths) {
    /** @type {Map<Slider, number>} */
    const some = new Map();
    for (const [slot, value] of lengths) {
      const slider = sliders.find((one) => one.slots.includes(slot));
      if (slider === undefined) continue;
      const [low, high] = reachOf(slider, sliders);
      some.set(slider, snapped(value, slider, high - low));
    }
    changeAll(some);
  }

  /** @param {Map<number, number>} scales chosen anew, by slots; all others are as given */
  function tell(scales) {
    sliders.forEach((slider, n) => {
      if (slider.plan !== undefined && !values.has(slider)) rows[n]?.set(scales.get(slider.slots[0] ?? -1) ?? slider.v, false);
    });
  }

  return { element: made, say: say_, drag, tell, again, drop: () => release(values) };
}

/**
 * @param {Slider} slider
 * @param {[number, number]} reach
 * @param {string} decimal
 * @param {string} name of its field
 * @param {{change: (slider: Slider, value: number) => void, release: () => void, refuse: (text: string) => void}} acts
 */
function givenRow(slider, [low, high], decimal, name, { change, release, refuse }) {
  const label = slider.plan === undefined ? slider.n : `${slider.n}, ${slider.plan}`;
  const range = /** @type {HTMLInputElement} */ (
    element("input", { type: "range", min: String(low), max: String(high), step: "any", "aria-label": label })
  );
  const field = /** @type {HTMLInputElement} */ (element("input", { type: "text", inputmode: "decimal", "aria-label": name }));
  const shown = (/** @type {number} */ value) => String(Number((value * slider.by).toPrecision(6))).replace(".", decimal);
  let good = slider.v;
  const set = (/** @type {number} */ value, /** @type {boolean} */ broken) => {
    if (!broken) good = value;
    range.max = String(Math.max(high, value));
    range.value = String(value);
    field.value = shown(value);
    field.setAttribute("aria-invalid", String(broken));
    range.setAttribute("aria-valuetext", `${shown(value)} ${slider.u}`);
  };
  range.addEventListener("input", () => change(slider, snapped(Number(range.value), slider, high - low)));
  // what cannot be assembled is let go of where it last could
  range.addEventListener("change", () => {
    set(good, false);
    release();
  });
  range.addEventListener("keyup", (event) => (RANGE_KEYS[event.key] === undefined ? undefined : release()));
  range.addEventListener("keydown", (event) => {
    const by = RANGE_KEYS[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    change(slider, snapped(good + (by * (high - low)) / STEPS, slider, high - low));
  });
  field.addEventListener("change", () => {
    const value = Number(field.value.replace(",", ".").replace("−", "-")) / slider.by;
    if (field.value.trim() === "" || !Number.isFinite(value)) {
      refuse(field.value);
      return set(good, false);
    }
    change(slider, value);
    release();
  });
  field.addEventListener("keydown", (event) => event.stopPropagation());
  set(slider.v, false);
  const made = element(
    "div",
    { class: "given" },
    element("span", {}, ...typeset(slider.l), ...(slider.plan === undefined ? [] : [element("small", {}, ` ${slider.plan}`)])),
    range,
    field,
    element("span", {}, slider.u),
  );
  return { element: made, set };
}

/** @param {Slider} slider */
function sliderName(slider) {
  return `${slider.n} ${slider.plan ?? ""}`;
}

/**
 * Return from where to where a range goes: on the side of nothing where what is given is.
 * @param {Slider} slider
 * @param {Slider[]} all
 * @returns {[number, number]}
 */
function reachOf(slider, all) {
  const largest = Math.max(...all.filter((one) => one.u === slider.u).map((one) => Math.abs(one.v)));
  const way = slider.v === 0 ? OF_LARGEST * largest || 1 : REACHED * Math.abs(slider.v);
  return [slider.v - way, slider.v + way];
}

/**
 * Return a value on a step of its range, what is given exactly where that is nearest.
 * @param {number} value
 * @param {Slider} slider
 * @param {number} width
 */
function snapped(value, slider, width) {
  const step = 10 ** Math.floor(Math.log10((width * slider.by) / STEPS));
  if (Math.abs(value - slider.v) * slider.by < step) return slider.v;
  return (Math.round((value * slider.by) / step) * step) / slider.by;
}

/**
 * @param {string} text
 * @param {() => void} act
 */
function button(text, act) {
  const made = /** @type {HTMLButtonElement} */ (element("button", { type: "button" }, text));
  made.addEventListener("click", act);
  return made;
}
