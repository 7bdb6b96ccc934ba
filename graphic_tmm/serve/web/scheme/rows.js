import { element } from "../../../page/web/dom.js";

/**
 * A value beside the scheme. Its element stays while the mechanism changes: what is typed and not sent, or not
 * answered, or was refused, is nobody else's to set.
 *
 * @typedef {import("../types.js").SchemeField} SchemeField
 */

export class Row {
  /**
   * @param {SchemeField} field
   * @param {boolean} fixed
   * @param {(choice: string) => string} say what a choice is called
   * @param {{typed: (row: Row) => void, focused: (field: SchemeField) => void, refused: () => void}} to
   */
  constructor(field, fixed, say, to) {
    this.field = field;
    this.to = to;
    /** What was sent last, and of how many acts the answers are missing. */
    this.sent = field.text;
    this.waiting = 0;
    /** Why what stands here was refused. @type {string[]} */
    this.refused = [];
    /** What is asked about what was typed. @type {HTMLElement | null} */
    this.question = null;
    const choice = field.choices.length > 0;
    const made = choice ? element("select", { "data-key": field.key }) : element("input", { "data-key": field.key, autocomplete: "off", spellcheck: "false" });
    this.input = /** @type {HTMLInputElement} */ (made);
    if (choice) made.append(...field.choices.map((one) => element("option", { value: one }, say(one))));
    this.input.value = field.text;
    this.input.disabled = fixed;
    this.label = element("span");
    this.element = element("label", { class: "scheme-field" }, this.label, made);
    made.addEventListener("change", () => (this.input.value === this.sent ? this.refuse([]) : to.typed(this)));
    made.addEventListener("blur", () => this.show());
    made.addEventListener("focus", () => to.focused(this.field));
    made.addEventListener("keydown", (event) => /** @type {KeyboardEvent} */ (event).key === "Escape" && this.back());
    this.set(field);
  }

  /** Whether what stands here is a person's, and not the file's. */
  get held() {
    return this.waiting > 0 || this.question !== null || this.refused.length > 0;
  }

  /** What stands among the others, in order. */
  get elements() {
    return this.question === null ? [this.element] : [this.element, this.question];
  }

  /** @param {SchemeField} field as the scene has it now */
  set(field) {
    this.field = field;
    this.label.textContent = field.label;
    this.label.title = field.says;
    // the sheet of styles writes it behind the label
    if (field.unit === "") delete this.label.dataset["unit"];
    else this.label.dataset["unit"] = field.unit;
    this.input.placeholder = field.placeholder;
    if (this.waiting > 0) return;
    this.sent = field.text;
    this.show();
  }

  /** Show what the scene has, unless somebody is at it. */
  show() {
    if (!this.held && document.activeElement !== this.input) this.input.value = this.field.text;
  }

  /** Take back what was typed and is not on its way. */
  back() {
    if (this.waiting > 0) return;
    this.refuse([]);
    this.ask(null);
    this.input.value = this.field.text;
  }

  /** @param {string[]} errors why what stands here was refused; none: it was not */
  refuse(errors) {
    this.refused = errors;
    this.input.setAttribute("aria-invalid", String(errors.length > 0));
    this.to.refused();
  }

  /** @param {HTMLElement | null} question */
  ask(question) {
    this.question?.remove();
    this.question = question;
    if (question !== null) this.element.after(question);
  }

  /**
   * Wait for the answer to what was typed; refused, it stays as it stands.
   * @param {Promise<string[]>} answered with why it was refused
   */
  async send(answered) {
    this.waiting += 1;
    const typed = this.input.value;
    this.sent = typed;
    this.ask(null);
    this.refuse([]);
    const errors = await answered;
    this.waiting -= 1;
    if (this.waiting > 0) return;
    this.sent = this.field.text;
    this.refuse(errors);
    // what stands as it was entered is told as the file has it: with its unit
    if (errors.length === 0 && this.input.value === typed) this.input.value = this.field.text;
    this.show();
  }
}

/**
 * Let elements stand in another, in order; the one that has the focus is not touched.
 * @param {HTMLElement} parent
 * @param {HTMLElement[]} wanted
 */
export function arrange(parent, wanted) {
  const there = [...parent.children];
  if (there.length === wanted.length && there.every((one, k) => one === wanted[k])) return;
  const at = wanted.findIndex((one) => one.contains(document.activeElement) && parent.contains(one));
  const still = wanted[at];
  if (still === undefined) return parent.replaceChildren(...wanted);
  for (const one of there) if (!wanted.includes(/** @type {HTMLElement} */ (one))) one.remove();
  still.before(...wanted.slice(0, at));
  still.after(...wanted.slice(at + 1));
}
