import { drawnElement, element } from "../dom.js";
import { INSTRUMENTS } from "./palette.js";

/**
 * Return the bar of the instruments, and what shows which one is taken.
 * @param {(key: string) => string} say
 * @param {(name: string) => void} choose
 */
export function paletteBar(say, choose) {
  const buttons = INSTRUMENTS.map(({ name, key, sign }) => {
    const picture = drawnElement("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, drawnElement("path", { d: sign }));
    const made = element("button", { type: "button", "aria-pressed": "false", title: `${say(`${name} takes`)} (${key})` });
    made.append(picture, element("span", {}, say(name)));
    made.setAttribute("aria-keyshortcuts", key);
    made.addEventListener("click", () => choose(name));
    return made;
  });
  const whole = element("div", { class: "palette", role: "group", "aria-label": say("palette") }, ...buttons);
  return {
    whole,
    /** @param {string} taken */
    show(taken) {
      INSTRUMENTS.forEach(({ name }, k) => buttons[k]?.setAttribute("aria-pressed", String(name === taken)));
    },
    /** Let the keyboard be at an instrument, for the next step. */
    rest() {
      const taken = buttons.find((one) => one.getAttribute("aria-pressed") === "true");
      (taken ?? buttons[0])?.focus({ preventScroll: true });
    },
  };
}
