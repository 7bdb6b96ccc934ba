import { element, iconButton } from "./dom.js";

/** @typedef {import("./state.js").State} State */

const MARK = "M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 18v.1";
const CROSS = "M6 6l12 12M18 6 6 18";
/**
 * The keys of each way of looking ("": of all), each row with the name of its words; keys that have words of their
 * own are named by these.
 * @type {Record<string, [string, string][]>}
 */
export const KEYS = {
  play: [
    ["→ PgDn", "next"],
    ["← PgUp", "previous"],
    ["Home", "first"],
    ["End", "last"],
    ["space", "keys run"],
  ],
  crank: [
    ["→ ↑", "degree on"],
    ["← ↓", "degree back"],
    ["PgUp", "leap on"],
    ["PgDn", "leap back"],
    ["space", "turn on"],
  ],
  sheets: [
    ["← → ↑ ↓", "keys move"],
    ["+", "larger"],
    ["−", "smaller"],
    ["0", "fit whole"],
    ["1", "fit true"],
    ["Enter", "play view"],
  ],
  lecture: [
    ["→ PgDn space", "keys onward"],
    ["← PgUp", "keys back"],
    ["↑ ↓", "keys views"],
    ["Home", "first"],
    ["End", "last"],
    ["P", "keys run"],
    ["F", "full screen"],
    ["Esc", "leave full screen"],
    ["B", "black"],
    ["S", "speaker"],
  ],
  "": [
    ["D", "dark"],
    ["← →", "keys tabs"],
    ["?", "help"],
  ],
};

/**
 * Return the panel that tells the keys, closed.
 * @param {Record<string, string>} words
 * @param {string[]} tabs
 */
export function helpPanel(words, tabs) {
  const say = (/** @type {string} */ key) => words[key] ?? key;
  const panel = /** @type {HTMLDialogElement} */ (element("dialog", { class: "help", "aria-labelledby": "help-head" }));
  const close = iconButton(CROSS, say("close"), () => panel.close());
  const parts = [...tabs, ""].filter((tab) => KEYS[tab] !== undefined);
  panel.append(
    element("div", { class: "help-head" }, element("h2", { id: "help-head" }, say("help")), close),
    ...parts.map((tab) =>
      element("section", {}, element("h3", {}, say(tab || "everywhere")), table(KEYS[tab] ?? [], say)),
    ),
  );
  panel.addEventListener("click", (event) => {
    if (event.target === panel) panel.close();
  });
  return panel;
}

/**
 * @param {[string, string][]} rows
 * @param {(key: string) => string} say
 */
function table(rows, say) {
  const caps = (/** @type {string} */ keys) =>
    keys.split(" ").flatMap((key) => [element("kbd", {}, say(key)), " "]);
  return element(
    "dl",
    { class: "keys" },
    ...rows.map(([keys, word]) => element("div", {}, element("dt", {}, ...caps(keys)), element("dd", {}, say(word)))),
  );
}

/**
 * Return the button that opens the panel.
 * @param {Record<string, string>} words
 * @param {HTMLDialogElement} panel
 */
export function helpButton(words, panel) {
  const made = iconButton(MARK, words["help"] ?? "", () => panel.showModal());
  made.querySelector("path")?.classList.add("line");
  return made;
}
