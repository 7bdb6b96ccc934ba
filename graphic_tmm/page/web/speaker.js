import { chooser } from "./chooser.js";
import { Clock } from "./clock.js";
import { element, filled } from "./dom.js";
import { closeIn } from "./enlarge.js";
import { groupOf } from "./equation.js";
import { keyOf, takenBy } from "./keys.js";
import { stepOver } from "./onward.js";
import { Stage } from "./stage.js";
import { tellingOf } from "./telling.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

/**
 * The speaker's window: what is told now and why, what comes next, how long it has taken; it follows the page and
 * drives it, and closes with it. It is made of this page's elements, so that nothing is loaded or parsed.
 */
export class Speaker {
  /**
   * @param {Data} data
   * @param {State} state
   * @param {Record<string, () => void>} keys what other keys do
   */
  constructor(data, state, keys) {
    this.data = data;
    this.state = state;
    /** @type {Window | null} */
    this.other = null;
    this.clock = new Clock(data.words);
    this.keys = {
      ...Object.fromEntries(["ArrowRight", "PageDown", " "].map((key) => [key, () => stepOver(state, 1)])),
      ...Object.fromEntries(["ArrowLeft", "PageUp"].map((key) => [key, () => stepOver(state, -1)])),
      ...keys,
    };
    this.title = element("h2", {});
    this.count = element("p", { class: "count" });
    this.now = element("div", { class: "telling" });
    this.next = element("div", { class: "telling" });
    this.picture = element("div", { class: "paper" });
    this.all = this.room();
    window.addEventListener("pagehide", () => this.other?.close());
    state.hear(() => this.show());
  }

  /**
   * Open the window, or bring it to the front; return whether the browser let it.
   */
  open() {
    if (this.other === null || this.other.closed) {
      this.other = window.open("", "", "popup,width=900,height=760");
      if (this.other === null) return false;
      const { document: there } = this.other;
      there.documentElement.lang = this.data.language;
      there.documentElement.classList.add("speaker");
      there.title = `${this.say("speaker")}: ${this.data.title}`;
      const style = element("style", {}, document.querySelector("style")?.textContent ?? "");
      const wide = element("meta", { name: "viewport", content: "width=device-width, initial-scale=1" });
      there.head.append(style, wide);
      there.body.append(this.all);
      there.addEventListener("keydown", (event) => this.press(event));
      this.other.setInterval(() => this.clock.show(), 500);
      this.show();
    }
    this.other.focus();
    return true;
  }

  /** @param {string} key */
  say(key) {
    return this.data.words[key] ?? key;
  }

  room() {
    const button = (/** @type {string} */ key, /** @type {() => void} */ act) => {
      const made = element("button", { type: "button" }, this.say(key));
      made.addEventListener("click", act);
      return made;
    };
    const bar = element(
      "div",
      { class: "speaker-bar" },
      button("previous", () => stepOver(this.state, -1)),
      button("next", () => stepOver(this.state, 1)),
      button("black", () => this.keys["b"]?.()),
      chooser(this.data, this.state),
    );
    const time = element("div", { class: "time" }, this.clock.face, this.clock.start, this.clock.reset);
    return element(
      "main",
      { class: "speaker-room" },
      element("header", {}, element("h1", {}, this.data.title), time),
      element("section", { class: "speaker-now" }, this.title, this.count, this.now),
      element("section", { class: "speaker-next" }, element("h2", {}, this.say("comes next")), this.next, this.picture),
      bar,
    );
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const act = this.keys[keyOf(event)];
    if (act === undefined || takenBy(event)) return;
    event.preventDefault();
    act();
  }

  /** Show what is told now and what comes next. */
  show() {
    if (this.other === null || this.other.closed || this.data.views.length === 0) return;
    const { view, place, data } = { view: this.state.view, place: this.state.place, data: this.data };
    const ready = place.picture >= view.pictures.length;
    const following = ready ? data.views[place.view + 1] : view;
    const step = ready ? 0 : place.picture + 1;
    this.title.textContent = view.title;
    this.count.textContent = filled(this.say("step of"), { step: place.picture, count: view.pictures.length });
    this.now.replaceChildren(...groupOf(view, place.picture), ...tellingOf(data, view, place.picture));
    if (following === undefined) {
      this.next.replaceChildren(element("p", {}, this.say("nothing follows")));
      this.picture.replaceChildren();
      return;
    }
    const head = ready ? [element("p", { class: "remark" }, following.title)] : [];
    this.next.replaceChildren(...head, ...tellingOf(data, following, step));
    const stage = new Stage(following);
    this.picture.replaceChildren(stage.svg);
    closeIn(stage.svg);
    stage.show(step);
  }
}
