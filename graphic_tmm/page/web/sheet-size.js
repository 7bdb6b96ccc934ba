import { element } from "./dom.js";

/** CSS px a millimetre, as every screen says. */
const SAID = 96 / 25.4;
const MARGIN = { least: 0.5, most: 1.6, step: 0.005 };
const REMEMBERED = "graphic-tmm screen";

/** How large a millimetre of this screen is; remembered as long as the page's tab is there. */
export class ScreenSize {
  constructor() {
    this.factor = remembered();
  }

  /** CSS px that are a millimetre on this screen. */
  get millimetre() {
    return SAID * this.factor;
  }

  /**
   * Build a line of 100 mm to lay a ruler at, and a slider that makes it so.
   * @param {import("./types.js").Data} data
   * @param {() => void} changed
   */
  panel(data, changed) {
    const say = (/** @type {string} */ key) => data.words[key] ?? key;
    const line = element("div", { class: "check-line" }, element("span", {}, say("100 mm")));
    const slider = /** @type {HTMLInputElement} */ (
      element("input", { type: "range", min: String(MARGIN.least), max: String(MARGIN.most), step: String(MARGIN.step) })
    );
    const told = element("span", {});
    const show = () => {
      line.style.width = `${100 * this.millimetre}px`;
      told.textContent = percent(this.factor, data.language);
    };
    slider.value = String(this.factor);
    slider.addEventListener("input", () => {
      this.factor = Number(slider.value);
      try {
        sessionStorage.setItem(REMEMBERED, slider.value);
      } catch {
        // a page that may remember nothing goes on without
      }
      show();
      changed();
    });
    show();
    const label = element("label", {}, say("calibrate"), slider, told);
    const summary = element("summary", {}, say("screen size"));
    return element("details", { class: "screen-size" }, summary, element("p", {}, say("ruler")), line, label);
  }
}

/**
 * Return a factor in percent, as a language writes it.
 * @param {number} factor
 * @param {string} language
 */
export function percent(factor, language) {
  return factor.toLocaleString(language, { style: "percent", maximumFractionDigits: 1 });
}

function remembered() {
  try {
    const found = Number(sessionStorage.getItem(REMEMBERED));
    return found >= MARGIN.least && found <= MARGIN.most ? found : 1;
  } catch {
    return 1;
  }
}
