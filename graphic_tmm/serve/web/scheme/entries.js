import { element } from "../../../page/web/dom.js";

/**
 * Keys of a section as they are filled in: a value, one of some words, boxes to tick, a table of two columns.
 *
 * @typedef {import("../types.js").SectionKey} SectionKey
 * @typedef {{element: HTMLElement, value: () => string}} Entry
 */

/**
 * @param {SectionKey} key
 * @param {(key: string) => string} say
 * @returns {Entry}
 */
export function entryOf(key, say) {
  if (key.form === "table") return table(key, say);
  if (key.form === "ticked") return ticked(key);
  const text = { placeholder: key.example, autocomplete: "off", spellcheck: "false" };
  const choices = key.choices.map(([value, says]) => element("option", { value }, says));
  const made = choices.length > 0 ? element("select", {}, element("option", { value: "" }), ...choices) : element("input", text);
  const input = /** @type {HTMLInputElement} */ (made);
  return { element: element("label", { class: "scheme-field" }, title(key), input), value: () => input.value };
}

/** @param {SectionKey} key */
function title({ says, wanted, unit }) {
  // the sheet of styles writes the unit behind it
  return element("span", unit === "" ? {} : { "data-unit": unit }, `${says}${wanted ? " *" : ""}`);
}

/**
 * @param {SectionKey} key
 * @param {HTMLElement[]} inner
 */
function group(key, ...inner) {
  return element("fieldset", { class: "scheme-field entries" }, element("legend", {}, title(key)), ...inner);
}

/**
 * @param {SectionKey} key
 * @returns {Entry}
 */
function ticked(key) {
  const boxes = key.choices.map(([value]) => /** @type {HTMLInputElement} */ (element("input", { type: "checkbox", value })));
  const rows = key.choices.map(([, says], k) => element("label", { class: "tick" }, /** @type {HTMLInputElement} */ (boxes[k]), says));
  return { element: group(key, element("div", { class: "ticks" }, ...rows)), value: () => boxes.filter((one) => one.checked).map((one) => one.value).join(", ") };
}

/**
 * A table that grows: behind the last row that is filled in there is an empty one.
 * @param {SectionKey} key
 * @param {(key: string) => string} say
 * @returns {Entry}
 */
function table(key, say) {
  const examples = key.example.split("; ").map((row) => row.split(": "));
  const made = element("div", { class: "rows" }, element("span", {}, say("scheme where")), element("span", {}, say("scheme how much")));
  /** @type {HTMLInputElement[][]} */
  const rows = [];
  const grow = () => {
    if (rows.at(-1)?.some((one) => one.value.trim() === "")) return;
    const n = rows.length + 1;
    const cells = ["scheme where", "scheme how much"].map((head, k) => {
      const shown = { placeholder: examples[rows.length]?.[k] ?? "", "aria-label": `${n}: ${say(head)}`, autocomplete: "off", spellcheck: "false" };
      return /** @type {HTMLInputElement} */ (element("input", shown));
    });
    for (const one of cells) one.addEventListener("input", grow);
    rows.push(cells);
    made.append(...cells);
  };
  grow();
  const value = () => rows.map((cells) => cells.map((one) => one.value.trim())).filter((cells) => cells.some(Boolean)).map((cells) => cells.join(": ")).join("; ");
  return { element: group(key, made), value };
}
