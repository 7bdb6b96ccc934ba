import { element, typeset } from "../dom.js";

/**
 * @typedef {{slot: number, letter: string, told: string, done: boolean}} Item a mark that may be picked: its letter, what it
 *   comes to ("" of a figure)
 * @typedef {{title: string, items: Item[]}} Group
 */

/**
 * What an instrument may be laid to, as a list: one stop of the keyboard, arrows go within it, Enter picks, and says on
 * what is picked that it is all.
 */
export class Listing {
  /**
   * @param {string} name
   * @param {(slot: number) => void} pick
   * @param {() => void} submit
   */
  constructor(name, pick, submit) {
    this.pick = pick;
    this.whole = element("div", { class: "listing", role: "group", "aria-label": name });
    this.whole.addEventListener("keydown", (event) => {
      const buttons = this.buttons;
      const now = buttons.findIndex((one) => one === document.activeElement);
      if (event.key === "Enter" && buttons[now]?.getAttribute("aria-pressed") === "true") {
        event.preventDefault();
        return submit();
      }
      const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (by === undefined || now < 0) return;
      event.preventDefault();
      this.go((now + by + buttons.length) % buttons.length);
    });
  }

  get buttons() {
    return /** @type {HTMLElement[]} */ ([...this.whole.querySelectorAll("button")]);
  }

  /**
   * @param {Group[]} groups
   * @param {number[]} picks
   */
  show(groups, picks) {
    const focused = this.whole.contains(document.activeElement) ? document.activeElement?.getAttribute("data-of") : null;
    const parts = groups.filter((group) => group.items.length > 0).map((group) => this.group(group, picks));
    this.whole.replaceChildren(...parts);
    const buttons = this.buttons;
    const kept = buttons.findIndex((one) => one.getAttribute("data-of") === focused);
    buttons.forEach((one, k) => (one.tabIndex = k === Math.max(kept, 0) ? 0 : -1));
    if (focused !== null) this.go(Math.max(kept, 0));
  }

  /**
   * @param {Group} group
   * @param {number[]} picks
   */
  group({ title, items }, picks) {
    const made = items.map(({ slot, letter, told }) => {
      const worth = letter === "" || told === "" ? told : ` = ${told}`;
      const inner = [...typeset(letter), worth];
      const button = element("button", { type: "button", "data-of": String(slot), "aria-pressed": String(picks.includes(slot)) });
      button.append(...inner);
      button.addEventListener("click", () => this.pick(slot));
      return button;
    });
    const row = element("div", { class: "row" }, ...made);
    return element("div", { class: "kind", role: "group", "aria-label": title }, element("p", {}, title), row);
  }

  /**
   * Let the keyboard be at one of the list.
   * @param {number} n
   */
  go(n) {
    this.buttons.forEach((one, k) => (one.tabIndex = k === n ? 0 : -1));
    this.buttons[n]?.focus({ preventScroll: true });
  }
}
