import { filled } from "../dom.js";
import { fourFigures } from "../crank-values.js";
import { LENGTHS } from "../lengths.js";
import { LiveChart } from "./charts.js";
import { jointRings } from "./joints.js";
import { LiveInk } from "./liveink.js";
import { lengthsPanel } from "./panel.js";
import { questionsPanel, Trials } from "./questions.js";
import { turnedInk } from "./range.js";
import { chosenScales } from "./rescale.js";
import { LiveRun } from "./run.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Dense} Dense
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Slider} Slider
 * @typedef {import("../lengths.js").Lengths} Lengths
 */

/**
 * Let lengths, and whatever else is given, be changed: the log runs anew with them at every angle.
 * @param {Data} data
 * @param {Dense} dense
 * @param {() => void} show
 * @returns {Lengths | null}
 */
export function begunLengths(data, dense, show) {
  const live = data.live;
  if (live === undefined) return null;
  const run = new LiveRun(live, dense.whole);
  const ink = dense.ties === undefined ? null : new LiveInk(dense.ties, dense.whole, run.frames, (k) => run.marks(k), (k) => run.few(k));
  const [pivot = -1, pin = -1] = live.pin;
  run.kept = [pivot, pin, ...live.paths, ...live.breaks.map(([slot]) => slot), ...(ink?.expressions.turning ?? [])];
  const zero = dense.zero;
  /** @type {Map<Slider, number>} */
  let good = new Map();
  /** Scale factors that are not as the sheet has them. @type {Map<number, number>} */
  let scales = new Map();
  const positions = dense.positions.map(([, index]) => index);
  /** @type {string[]} */
  let whys = [];
  /** @type {ReturnType<typeof turnedInk> | null} */
  let turned = null;
  /** @type {(k: number) => void} */
  let rings = () => {};
  const panel = lengthsPanel(live.sliders, data.words, dense.decimal, take, release);
  const questions =
    live.out === undefined ? null : questionsPanel(new Trials(run, live.out, broken), live, words, dense.decimal, () => give(good));
  if (questions !== null) panel.element.append(questions.element);

  /**
   * Take values of what is given; where nothing can be assembled with them nothing moves.
   * @param {Map<Slider, number>} values those that are not as given
   * @param {Slider | null} last the one that was changed last
   */
  function take(values, last) {
    if (values.size === 0) scales.clear();
    give(values);
    whys = values.size === 0 ? [] : run.frames.map((_, k) => broken(k));
    const there = whys.filter((why, k) => why === "" && k < dense.whole).length;
    if (values.size > 0 && there === 0) {
      panel.say(refusal(values, last, whys[0] ?? ""));
      questions?.judge(values, true);
      give(good);
      whys = good.size === 0 ? [] : run.frames.map((_, k) => broken(k));
      return false;
    }
    good = new Map(values);
    const share = filled(words("exists"), { share: `${((100 * there) / dense.whole).toFixed(0)} %` });
    panel.say(values.size === 0 ? "" : there < dense.whole ? `${words("own lengths")} ${share}` : words("own lengths"));
    if (values.size === 0) settle();
    follow();
    questions?.judge(values);
    return true;
  }

  /** @param {Map<Slider, number>} values */
  function give(values) {
    run.give(new Map([...scales, ...givenBySlots(values)]));
  }

  /**
   * Choose scale factors anew, but for those that somebody has changed himself, and let figures settle in their boxes.
   * @param {Map<Slider, number>} values
   */
  function release(values) {
    if (live === undefined || values.size === 0) return;
    const kept = givenBySlots(values);
    const found = chosenScales(live.scales, (k) => run.marks(k), positions, new Set(kept.keys()));
    scales = new Map([...found].filter(([slot, mu]) => live.given[slot]?.v?.[0] !== mu));
    give(values);
    whys = run.frames.map((_, k) => broken(k));
    settle();
    follow();
  }

  function settle() {
    panel.tell(scales);
    if (ink === null) return;
    ink.released++;
    ink.places = positions;
    ink.drawn = (k) => whys[k] === "";
  }

  /** Let what is shown follow what is given. */
  function follow() {
    LENGTHS.given = { values: run.changed, says: [...good].map(([slider, value]) => inWords(slider, value)).join(", ") };
    ink?.given(good.size > 0);
    dense.zero = good.size > 0 && live !== undefined ? (bearing(run.marks(0)) ?? zero) : zero;
    const drawn = (/** @type {number} */ slot) => whys.map((why, k) => (why === "" ? pointOf(run.few(k)[slot]) : null));
    turned?.(good.size > 0, drawn(pin), live?.paths.map(drawn) ?? []);
    show();
  }

  /** @param {string} key */
  function words(key) {
    return data.words[key] ?? key;
  }

  /**
   * @param {Map<Slider, number>} values
   * @param {Slider | null} last
   * @param {string} why
   */
  function refusal(values, last, why) {
    const value = last === null ? "" : inWords(last, values.get(last) ?? last.v);
    return filled(words("breaks"), { value, why });
  }

  /**
   * @param {Slider} slider
   * @param {number} value
   */
  function inWords(slider, value) {
    return `${slider.l} = ${fourFigures(value * slider.by, dense.decimal)} ${slider.u}`.trim();
  }

  /**
   * Return which step has no answer at an angle, and why; "" where all have.
   * @param {number} k
   */
  function broken(k) {
    const marks = run.few(k);
    return live?.breaks.find(([slot]) => marks[slot] !== undefined && !known(marks[slot]))?.[1] ?? "";
  }

  /** @param {(Drawn | undefined)[]} marks */
  function bearing(marks) {
    const [from, to] = [pointOf(marks[pivot]), pointOf(marks[pin])];
    if (from === null || to === null || dense.ends !== undefined) return null;
    return (Math.atan2(to.im - from.im, to.re - from.re) * 180) / Math.PI;
  }

  /** @param {number} k */
  function pinAt(k) {
    return pointOf(run.few(k)[pin]);
  }

  return {
    ink,
    panel: panel.element,
    again: panel.again,
    why: (k) => (good.size === 0 ? null : (whys[k] ?? "")),
    number([slot = -1, scale = -1, size = 0], k) {
      const marks = run.marks(k);
      const value = marks[slot];
      const mm = typeof value === "number" ? value : value !== undefined && "re" in value ? Math.hypot(value.re, value.im) : NaN;
      const found = mm * (scale < 0 ? 1 : Number(marks[scale]));
      return size === 1 ? Math.abs(found) : found;
    },
    changed: () => good.size > 0,
    scale: (name, k) => (good.size === 0 ? NaN : Number(run.marks(k)[live.scales.shown[name] ?? -1])),
    mark: (slot) => Number(run.charts()[0]?.[slot]),
    chart: (svg, cursors) => new LiveChart(run, dense, svg, cursors),
    stand: (k) => rings(k),
    pin: (k) => (good.size === 0 ? null : pinAt(k)),
    lead(svg, numbers) {
      turned = turnedInk(svg, dense, live.paths.length, numbers);
      rings = jointRings(svg, live.joints, (k) => run.marks(k), panel.drag, panel.drop);
      panel.element.addEventListener("toggle", () => svg.classList.toggle("adjusted", /** @type {HTMLDetailsElement} */ (panel.element).open));
    },
  };
}

/** @param {Map<Slider, number>} values */
function givenBySlots(values) {
  const given = (/** @type {[Slider, number]} */ [slider, value]) => [...slider.slots.map((slot) => [slot, value]), ...(slider.minus ?? []).map((slot) => [slot, -value])];
  return new Map(/** @type {[number, number][]} */ ([...values].flatMap(given)));
}

/** @param {Drawn | undefined} mark */
function pointOf(mark) {
  return mark !== undefined && typeof mark !== "number" && "re" in mark && known(mark) ? mark : null;
}

/**
 * Tell whether a mark is there: all its numbers are.
 * @param {Drawn | undefined} mark
 * @returns {boolean}
 */
function known(mark) {
  if (mark === undefined) return false;
  if (typeof mark === "number") return Number.isFinite(mark);
  if ("re" in mark) return Number.isFinite(mark.re) && Number.isFinite(mark.im);
  return "at" in mark ? known(mark.at) && known(mark.along) : known(mark.centre) && known(mark.radius);
}
