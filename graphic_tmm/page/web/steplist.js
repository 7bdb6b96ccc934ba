import { element, filled, sentenceOf, typeset } from "./dom.js";
import { sumOf } from "./equation.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Line} Line
 * @typedef {import("./types.js").Run} Run
 * @typedef {import("./types.js").View} View
 */

/**
 * The steps of a view as a list of buttons under the headings of their groups: the drawing for those who cannot see it.
 * One stop of the keyboard, arrows go among them.
 */
export class StepList {
  /**
   * @param {Data} data
   * @param {View} view
   * @param {(n: number) => void} go
   */
  constructor(data, view, go) {
    const say = (/** @type {string} */ key) => data.words[key] ?? key;
    /** @type {HTMLElement[]} */
    this.buttons = [];
    this.whole = element("div", { class: "steps", role: "group", "aria-label": say("steps") });
    let list = element("ol", { start: "0" });
    this.whole.append(element("h2", { class: "unseen" }, say("steps")), list);
    this.whole.addEventListener("keydown", (event) => {
      const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      go(this.buttons.findIndex((button) => button.tabIndex === 0) + by);
    });
    view.pictures.forEach((picture, n) => {
      const heads = picture.lines.filter((line) => line.head);
      if (heads.length > 0) {
        list = element("ol", { start: String(n) });
        this.whole.append(...heads.map((line) => element("h3", {}, ...headOf(line))), list);
      }
      list.append(this.item(n, ...sentenceAt(data, view, n), go));
    });
    list.append(this.item(view.pictures.length, say("ready"), "", go));
  }

  /**
   * @param {number} n
   * @param {Run[] | string} text
   * @param {string} of
   * @param {(n: number) => void} go
   */
  item(n, text, of, go) {
    const inner = typeof text === "string" ? [text] : sentenceOf(text);
    const button = element("button", { type: "button", ...(of ? { "data-of": of } : {}) }, ...inner);
    button.addEventListener("click", () => go(n));
    this.buttons.push(button);
    return element("li", { value: String(n) }, button);
  }

  /**
   * Mark the step of a stop and bring it into sight.
   * @param {number} n
   */
  show(n) {
    const within = this.whole.contains(document.activeElement);
    this.buttons.forEach((button, k) => {
      button.tabIndex = k === n ? 0 : -1;
      if (k === n) button.setAttribute("aria-current", "step");
      else button.removeAttribute("aria-current");
    });
    const now = this.buttons[n];
    if (within) now?.focus({ preventScroll: true });
    const frame = this.whole;
    if (now === undefined || frame.scrollHeight <= frame.clientHeight) return;
    const [top, high, seen] = [now.offsetTop, now.offsetHeight, frame.clientHeight];
    const near = top - high > frame.scrollTop && top + 2 * high < frame.scrollTop + seen;
    if (!near) frame.scrollTop = top - seen / 3;
  }
}

/**
 * Return the sentence of a stop, and the marks of its step.
 * @param {Data} data
 * @param {View} view
 * @param {number} n
 * @returns {[Run[] | string, string]}
 */
function sentenceAt(data, view, n) {
  const picture = view.pictures[n];
  if (n === 0) return [data.words["given"] ?? "", ""];
  if (picture?.again) {
    return [filled(data.words["again"] ?? "", { name: view.names[String(picture.at)] ?? "" }), ""];
  }
  const line = picture?.lines.find((one) => !one.head && one.text);
  return [line?.text ?? "", line?.it === undefined ? "" : String(line.it)];
}

/** @param {Line} line */
function headOf(line) {
  if (line.equation) return [sumOf(line.equation, Infinity)];
  return (line.text ?? []).flatMap((run) => typeset(String(run)));
}
