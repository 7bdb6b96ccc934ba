import { element, iconButton } from "../../../page/web/dom.js";


/**
 * The drive of a scheme that is whole: where it stands, and how all goes with it.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("../types.js").SchemeAnswer} SchemeAnswer
 * @typedef {import("../types.js").Turn} Turn
 * @typedef {import("./editor.js").Editor} Editor
 */

const PLAY = "M7 4L20 12L7 20Z";
const STOP = "M6 5H10V19H6ZM14 5H18V19H14Z";
/** A turn takes so long, ms. */
const TURN = 6000;
/** So many places of it are asked for. */
const PLACES = 120;

export class Turning {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    this.range = /** @type {HTMLInputElement} */ (element("input", { type: "range", min: "0", max: String(PLACES), step: "1", "aria-label": editor.say("scheme turn") }));
    this.output = element("output", {});
    this.play = iconButton(PLAY, editor.say("scheme play"), () => this.toggle());
    this.element = element("div", { class: "scheme-turn" }, this.play, this.range, this.output);
    this.range.disabled = true;
    /** @type {Turn | null} */
    this.turn = null;
    this.text = "";
    this.at = 0;
    this.running = 0;
    this.range.addEventListener("input", () => void this.go(Number(this.range.value)));
    this.range.addEventListener("change", () => void this.stand());
  }

  /** @param {SchemeAnswer} answer */
  follow(answer) {
    if (answer.text === null || answer.text !== this.text) {
      this.stop();
      this.turn = null;
      this.text = answer.text ?? "";
    }
    this.range.disabled = answer.text === null;
    this.play.toggleAttribute("disabled", answer.text === null);
    const { sweep, at } = answer;
    if (sweep === null || at === null) return;
    const share = (at - sweep.low) / (sweep.high - sweep.low);
    this.range.value = String(Math.round(PLACES * (sweep.closed ? share - Math.floor(share) : share)));
    this.output.textContent = this.placeText(at);
  }

  /** @param {number} at */
  placeText(at) {
    const sweep = this.editor.answer?.sweep;
    if (!sweep) return "";
    return sweep.unit === "°" ? `${sweep.letter} = ${Math.round(10 * at) / 10}°` : `${sweep.letter} = ${Math.round(10000 * at) / 10} ${this.editor.say("mm")}`;
  }

  /** Have the places of a turn. */
  async load() {
    const { editor } = this;
    if (this.turn !== null || editor.text === "" || editor.waiting > 0) return this.turn;
    const { answer } = await editor.send({ text: editor.text, turn: PLACES, at: editor.answer?.at ?? null });
    this.turn = answer?.turn ?? null;
    return this.turn;
  }

  /**
   * Show a place of the turn.
   * @param {number} k
   */
  async go(k) {
    const turn = await this.load();
    if (turn === null) return;
    this.at = k;
    this.range.value = String(k);
    this.output.textContent = this.placeText(turn.at[k] ?? 0);
    const { sketch, paper, chosen } = this.editor;
    const moved = movedTo(sketch, turn, k);
    if (moved !== null) paper.show(moved, chosen, turn.loads[k]);
  }

  /** Stand where it was turned to. */
  async stand() {
    const { editor } = this;
    const turn = await this.load();
    const at = turn?.at[this.at];
    if (turn === null || at === undefined) return;
    if (movedTo(editor.sketch, turn, this.at) === null) {
      editor.tell(editor.say("scheme not there"));
      editor.changed();
      return;
    }
    await editor.ask(() => ({ at }));
  }

  toggle() {
    if (this.running !== 0) this.stop();
    else void this.run();
  }

  async run() {
    if ((await this.load()) === null) return;
    const begun = performance.now() - (TURN * Number(this.range.value)) / PLACES;
    this.show(STOP);
    const step = (/** @type {number} */ now) => {
      const share = (now - begun) / TURN;
      const closed = this.editor.answer?.sweep?.closed === true;
      const way = closed ? share % 1 : 1 - Math.abs(1 - (share % 2));
      void this.go(Math.round(PLACES * way));
      this.running = requestAnimationFrame(step);
    };
    this.running = requestAnimationFrame(step);
  }

  stop() {
    if (this.running === 0) return;
    cancelAnimationFrame(this.running);
    this.running = 0;
    this.show(PLAY);
    void this.stand();
  }

  /** @param {string} icon */
  show(icon) {
    this.play.querySelector("path")?.setAttribute("d", icon);
    this.play.setAttribute("aria-pressed", String(icon === STOP));
  }
}

/**
 * Return a sketch at a place of the turn; null where it cannot be drawn.
 * @param {Sketch} sketch
 * @param {Turn} turn
 * @param {number} k
 * @returns {Sketch | null}
 */
function movedTo(sketch, turn, k) {
  const places = { ...sketch.places };
  for (const [letter, row] of Object.entries(turn.places)) {
    const place = row[k];
    if (!place) return null;
    if (letter in places) places[letter] = place;
  }
  return { ...sketch, places };
}

