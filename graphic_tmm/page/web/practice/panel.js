import { element } from "../dom.js";
import { figureForm, spotForm } from "./answering.js";
import { Listing } from "./listing.js";
import { paletteBar } from "./palettebar.js";
import { tallying } from "./tallying.js";

/**
 * What stands beside the board: instruments, what they are laid to, the answer, the verdict, help, the score.
 *
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {{choose: (name: string) => void, pick: (slot: number) => void, submit: () => void,
 *   tell: (value: number, text: string) => void, aim: (spot: Spot) => void, prick: () => void, leave: () => void,
 *   help: () => void, side: (side: number) => void, redo: (slot: number) => void, clear: () => void, record: () => void, readings: () => void,
 *   refuse: (trouble: string) => void, again: () => void}} Acts
 */

export class Panel {
  /**
   * @param {(key: string) => string} say
   * @param {string} decimal
   * @param {Acts} acts
   */
  constructor(say, decimal, acts) {
    this.palette = paletteBar(say, acts.choose);
    this.goal = element("p", { class: "goal" });
    this.prompt = element("p", { class: "prompt" });
    this.listing = new Listing(say("laid to"), acts.pick, acts.submit);
    this.figure = figureForm(say, decimal, acts.tell, acts.refuse);
    this.spot = spotForm(say, decimal, acts.aim, acts.prick);
    this.sides = [1, -1].map((side) => this.button("", () => acts.side(side)));
    this.distances = element("p", { class: "distances" });
    this.verdict = element("div", { class: "judged" });
    this.hint = element("div", { class: "hinted" });
    this.whole = this.button(say("that is all"), acts.submit, "submit");
    this.leave = this.button(say("leave"), acts.leave, "leave");
    this.again = this.button("", acts.again, "leave");
    this.help = this.button("", acts.help, "ask");
    this.data = element("p", { class: "distances data" });
    this.anew = this.button(say("begin anew"), acts.clear);
    /** What the button of beginning anew asks, what it is called. */
    this.asks = [say("surely anew"), say("begin anew")];
    this.anew.addEventListener("blur", () => this.doubted(false));
    this.readings = this.button(say("save readings"), acts.readings);
    this.tally = tallying(say, acts.redo);
    const step = element("div", { class: "step" }, this.prompt, this.data, this.listing.whole, this.whole, this.figure.form, this.spot.form, ...this.sides, this.distances);
    const told = element("div", { class: "told" }, this.verdict, this.leave, this.again, this.hint, this.help);
    const files = element(
      "div",
      { class: "files" },
      this.button(say("save record"), acts.record),
      this.readings,
      this.anew,
    );
    this.body = element("div", { class: "panel", tabindex: "0" }, step, told, this.tally.whole, files);
  }

  /**
   * Ask before all that is done is wiped; return whether that was not asked yet.
   * @param {boolean} much whether there is something to be lost
   */
  doubted(much) {
    const [asks = "", name = ""] = this.asks;
    const asked = this.anew.textContent === asks;
    this.anew.textContent = much && !asked ? asks : name;
    return much && !asked;
  }

  /**
   * @param {string} name
   * @param {() => void} act
   * @param {string} kind
   */
  button(name, act, kind = "") {
    const made = element("button", { type: "button", ...(kind ? { class: kind } : {}) }, name);
    made.addEventListener("click", act);
    return made;
  }
}
