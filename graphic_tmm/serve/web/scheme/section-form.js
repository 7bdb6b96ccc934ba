import { element } from "../../../page/web/dom.js";
import { addSection } from "./editor-acts.js";
import { entryOf } from "./entries.js";

/**
 * A section that the task gives besides: chosen by what it is, its values typed, then added to the scene.
 *
 * @typedef {import("../types.js").OfferedSection} OfferedSection
 * @typedef {import("./editor.js").Editor} Editor
 */

/** So many keys are seen at once, those that are wanted first: of a load what, where, how large, and whither. */
const SEEN = 6;

export class SectionForm {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    /** @type {OfferedSection[]} */
    this.sections = [];
    this.shown = "";
    this.choice = /** @type {HTMLSelectElement} */ (element("select", { "aria-label": editor.say("scheme add"), "data-key": "section" }));
    this.there = element("ol", { class: "section-there" });
    this.keys = element("div", { class: "section-keys" });
    this.added = element("p", { class: "section-added" });
    this.element = element("div", { class: "more" }, this.choice, this.added, this.there, this.keys);
    this.choice.addEventListener("change", () => this.choose());
  }

  /**
   * Offer sections; one that is being filled in stays.
   * @param {OfferedSection[]} sections
   */
  show(sections) {
    const { editor } = this;
    const state = JSON.stringify(sections);
    this.element.hidden = sections.length === 0 || editor.fixed;
    if (state === this.shown) return;
    this.shown = state;
    this.sections = sections;
    const { value } = this.choice;
    const first = element("option", { value: "" }, editor.say("scheme add"));
    this.choice.replaceChildren(first, ...sections.map((one) => element("option", { value: one.name }, one.says)));
    this.choice.value = sections.some((one) => one.name === value) ? value : "";
    if (this.choice.value === "") this.keys.replaceChildren();
    this.list();
  }

  /** Say what there is of the section that is chosen. */
  list() {
    const there = this.section?.there ?? [];
    this.there.replaceChildren(...there.map((one) => element("li", {}, one)));
    this.there.hidden = there.length === 0;
  }

  get section() {
    return this.sections.find((one) => one.name === this.choice.value);
  }

  choose() {
    const { section } = this;
    this.added.textContent = "";
    this.keys.replaceChildren(...(section === undefined ? [] : [this.form(section)]));
    this.list();
  }

  /** @param {OfferedSection} section */
  form(section) {
    const { editor } = this;
    const entries = section.keys.map((key) => ({ name: key.name, ...entryOf(key, (word) => editor.say(word)) }));
    const rows = entries.map((one) => one.element);
    const others = rows.slice(SEEN);
    const more = element("details", {}, element("summary", {}, editor.say("more")), ...others);
    const button = element("button", { type: "submit" }, editor.say("scheme add it"));
    const form = element("form", {}, ...rows.slice(0, SEEN), ...(others.length > 0 ? [more] : []), button);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const typed = entries.map(({ name, value }) => [name, value()]).filter(([, value]) => value?.trim() !== "");
      void this.add(section, Object.fromEntries(typed), /** @type {HTMLButtonElement} */ (button));
    });
    return form;
  }

  /**
   * Add it once; then the form is empty and closed. Refused, it stays.
   * @param {OfferedSection} section
   * @param {Record<string, string>} typed
   * @param {HTMLButtonElement} button
   */
  async add({ name, says }, typed, button) {
    if (button.disabled) return;
    button.disabled = true;
    const errors = await addSection(this.editor, name, typed);
    button.disabled = false;
    if (errors.length > 0) return;
    this.choice.value = "";
    this.choose();
    this.added.textContent = this.editor.say("scheme added", { what: [says, ...Object.values(typed)].join(", ") });
    this.editor.tell(this.added.textContent);
    this.choice.focus();
  }
}
