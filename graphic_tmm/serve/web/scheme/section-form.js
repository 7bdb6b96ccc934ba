import { element } from "../../../page/web/dom.js";
import { addSection } from "./editor-acts.js";

/**
 * A section that the task gives besides: chosen by what it is, its values typed, then added to the scene.
 *
 * @typedef {import("../types.js").OfferedSection} OfferedSection
 * @typedef {import("./editor.js").Editor} Editor
 */

/**
 * @param {Editor} editor
 * @param {OfferedSection[]} sections
 * @returns {HTMLElement[]}
 */
export function sectionForm(editor, sections) {
  if (sections.length === 0 || editor.fixed) return [];
  const choice = /** @type {HTMLSelectElement} */ (element("select", { "aria-label": editor.say("scheme add"), "data-key": "section" }));
  choice.append(element("option", { value: "" }, editor.say("scheme add")));
  choice.append(...sections.map((one) => element("option", { value: one.name }, `${one.says} [${one.name}]`)));
  const keys = element("div", { class: "section-keys" });
  choice.addEventListener("change", () => {
    const section = sections.find((one) => one.name === choice.value);
    keys.replaceChildren(...(section === undefined ? [] : [keysOf(editor, section)]));
  });
  return [choice, keys];
}

/**
 * @param {Editor} editor
 * @param {OfferedSection} section
 */
function keysOf(editor, section) {
  /** @type {Map<string, HTMLInputElement>} */
  const inputs = new Map();
  const rows = section.keys.map((key) => {
    const choices = key.choices.map((one) => element("option", { value: one }, one));
    const text = { placeholder: key.example, autocomplete: "off", spellcheck: "false" };
    const made = choices.length > 0 ? element("select", {}, element("option", { value: "" }), ...choices) : element("input", text);
    inputs.set(key.name, /** @type {HTMLInputElement} */ (made));
    const says = element("span", {}, `${key.says}${key.wanted ? " *" : ""}`);
    return { key, row: element("label", { class: "scheme-field" }, says, made) };
  });
  const wanted = rows.filter(({ key }) => key.wanted).map(({ row }) => row);
  const others = rows.filter(({ key }) => !key.wanted).map(({ row }) => row);
  const more = element("details", {}, element("summary", {}, editor.say("more")), ...others);
  more.toggleAttribute("open", wanted.length === 0);
  const button = element("button", { type: "submit" }, editor.say("scheme add it"));
  const form = element("form", {}, ...wanted, ...(others.length > 0 ? [more] : []), button);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const typed = [...inputs].flatMap(([name, { value }]) => (value.trim() === "" ? [] : [[name, value]]));
    addSection(editor, section.name, Object.fromEntries(typed));
  });
  return form;
}
