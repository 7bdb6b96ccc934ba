import { element, filled } from "../../page/web/dom.js";

/** @typedef {import("./types.js").Fault} Fault */
/** @typedef {import("./types.js").Field} Field */
/** @typedef {import("./types.js").Words} Words */
/** @typedef {HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement} Input */

let count = 0;
/** Of more characters a text has several lines to stand on. */
const LONG = 36;

/**
 * Return what a value is typed into.
 * @param {Field} field
 */
function shapeOf(field) {
  if (field.kind === "choice" || field.kind === "switch") return "select";
  return field.text.length > LONG || field.text.includes("\n") ? "textarea" : "input";
}

/**
 * What decides how a field looks, but for what stands in it.
 * @param {Field} field
 */
export function mould(field) {
  return [field.key, field.label, shapeOf(field), field.written, field.choices, field.default, field.wanted];
}

/** A value of the scene: written when it is left or by Enter, taken back by Escape. */
export class FieldView {
  /**
   * @param {Words} words
   * @param {Field} field
   * @param {boolean} fixed
   * @param {(field: FieldView) => void} save
   */
  constructor(words, field, fixed, save) {
    this.words = words;
    this.field = field;
    this.save = save;
    /** Whether it is being moved: the focus that it loses then is no leaving. */
    this.held = false;
    const id = `field-${(count += 1)}`;
    this.input = this.inputOf(field);
    this.input.id = id;
    this.input.setAttribute("aria-describedby", `${id}-says ${id}-fault`);
    this.input.disabled = fixed;
    this.says = element("p", { class: "says", id: `${id}-says` });
    this.wrong = element("p", { class: "wrong", id: `${id}-fault` });
    const label = element("label", { for: id }, field.label);
    this.element = element("div", { class: "field", "data-key": field.key }, label, this.input, this.says, this.wrong);
    this.input.addEventListener("change", () => this.left());
    this.input.addEventListener("keydown", (event) => this.key(/** @type {KeyboardEvent} */ (event)));
    this.input.value = field.text;
    this.set(field);
  }

  /** Whether something was typed that the file does not have. */
  get changed() {
    return this.input.value !== this.field.text;
  }

  /**
   * @param {Field} field
   * @returns {Input}
   */
  inputOf(field) {
    const shape = shapeOf(field);
    if (shape === "select") {
      const made = document.createElement("select");
      const names = { true: this.words["on"] ?? "", false: this.words["off"] ?? "" };
      for (const choice of field.choices) {
        const shown = field.kind === "switch" ? names[/** @type {"true" | "false"} */ (choice)] : choice;
        made.append(element("option", { value: choice }, shown));
      }
      if (!field.wanted || !field.written) made.prepend(element("option", { value: "" }, this.otherwise(field)));
      return made;
    }
    const made = document.createElement(shape);
    made.autocomplete = "off";
    made.spellcheck = false;
    made.placeholder = this.otherwise(field);
    if (made instanceof HTMLTextAreaElement) made.rows = Math.min(8, Math.ceil(field.text.length / LONG) + 1);
    return made;
  }

  /** What holds where nothing is written. @param {Field} field */
  otherwise(field) {
    if (field.wanted) return this.words["needed"] ?? "";
    if (field.default === "") return this.words["usual"] ?? "";
    return filled(this.words["default"] ?? "", { default: field.default });
  }

  /**
   * Take what the file has now; what was typed meanwhile stays.
   * @param {Field} field
   */
  set(field) {
    const typed = this.changed;
    this.field = field;
    this.says.textContent = [field.says, field.unit].filter((one) => one !== "").join(" · ");
    if (!typed) this.input.value = field.text;
    if (!this.changed) this.tell([]);
  }

  /**
   * Whether the file has another value by now than the one over which something was typed.
   * @param {Field} field
   */
  overtaken(field) {
    return this.changed && this.field.text !== field.text;
  }

  /**
   * Take what was typed for what the file has: it was written.
   * @param {string} typed
   */
  accept(typed) {
    this.field = { ...this.field, text: typed, written: typed !== "" };
    if (!this.changed) this.tell([]);
  }

  left() {
    if (this.changed && !this.held) this.save(this);
  }

  /**
   * Be moved without being left; return what gives the focus back, to a field that has come in this one's place.
   * @returns {(view?: FieldView) => void}
   */
  hold() {
    this.held = true;
    const { input } = this;
    const [begin, end] = input instanceof HTMLSelectElement ? [null, null] : [input.selectionStart, input.selectionEnd];
    return (view) => {
      this.held = false;
      view?.input.focus({ preventScroll: true });
      if (view && !(view.input instanceof HTMLSelectElement)) view.input.setSelectionRange(begin, end);
    };
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.key === "Escape") {
      this.back();
      event.preventDefault();
    } else if (event.key === "Enter" && !event.shiftKey && !event.isComposing) {
      event.preventDefault();
      this.left();
    }
  }

  /** Take back what was typed. */
  back() {
    this.input.value = this.field.text;
    this.tell([]);
  }

  /**
   * Say beside the field why it was refused; nothing, if it was not.
   * @param {string[]} lines
   */
  tell(lines) {
    this.wrong.replaceChildren(...lines.map((line) => element("span", {}, line)));
    this.input.setAttribute("aria-invalid", String(lines.length > 0));
    this.element.classList.toggle("refused", lines.length > 0);
  }
}
