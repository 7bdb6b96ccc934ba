import { element } from "./dom.js";

/**
 * The time that has gone since the speaker began, on wish stopped and set back.
 */
export class Clock {
  /** @param {Record<string, string>} words */
  constructor(words) {
    this.words = words;
    this.gone = 0;
    this.since = 0;
    this.face = element("output", { class: "clock", role: "timer", "aria-label": words["clock"] ?? "" });
    this.start = element("button", { type: "button" });
    this.reset = element("button", { type: "button" }, words["clock back"] ?? "");
    this.start.addEventListener("click", () => this.turn());
    this.reset.addEventListener("click", () => {
      this.gone = 0;
      this.since = this.since === 0 ? 0 : performance.now();
      this.show();
    });
    this.show();
  }

  /** Start it or stop it. */
  turn() {
    const now = performance.now();
    if (this.since === 0) this.since = now;
    else {
      this.gone += now - this.since;
      this.since = 0;
    }
    this.show();
  }

  /** Show the time. */
  show() {
    const all = Math.floor((this.gone + (this.since === 0 ? 0 : performance.now() - this.since)) / 1000);
    const [hours, minutes, seconds] = [Math.floor(all / 3600), Math.floor(all / 60) % 60, all % 60];
    const two = (/** @type {number} */ part) => String(part).padStart(2, "0");
    this.face.textContent = hours > 0 ? `${hours}:${two(minutes)}:${two(seconds)}` : `${minutes}:${two(seconds)}`;
    this.start.textContent = this.words[this.since === 0 ? "clock start" : "clock stop"] ?? "";
  }
}
