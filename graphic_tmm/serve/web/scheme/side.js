import { element } from "../../../page/web/dom.js";
import { renameLetter, renameLink, typeValue } from "./editor-acts.js";
import { sectionForm } from "./section-form.js";
import { bodiesAt, bodyOf, frameOf } from "./sketch.js";

/**
 * What is said beside the paper: what the mechanism is and lacks, the chosen pin or link, lengths, and what the task
 * gives next.
 *
 * @typedef {import("../types.js").SchemeField} SchemeField
 * @typedef {import("./editor.js").Editor} Editor
 */

export class Side {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    this.structure = element("p", { class: "structure" });
    this.chosen = element("div", { class: "chosen-part" });
    this.lengths = element("div", { class: "lengths" });
    this.next = element("div", { class: "next" });
    this.errors = element("p", { class: "wrong", role: "alert" });
    this.more = element("div", { class: "more" });
    this.how = element("details", { class: "how" }, element("summary", {}, editor.say("scheme how")), element("p", {}, editor.say("scheme how text")), element("p", {}, editor.say("scheme keys")));
    this.element = element("div", { class: "scheme-side" }, this.structure, this.errors, this.chosen, this.lengths, this.next, this.more, this.how);
    this.shown = "";
  }

  show() {
    const { editor } = this;
    const { answer, chosen, sketch } = editor;
    this.structure.replaceChildren(...this.structureLines());
    const state = JSON.stringify([answer?.fields, chosen, sketch.links, sketch.drive]);
    if (state === this.shown) return;
    this.shown = state;
    this.more.replaceChildren(...sectionForm(editor, answer?.sections ?? []));
    const focused = document.activeElement?.getAttribute("data-key");
    this.chosen.replaceChildren(...this.chosenPart());
    const fields = answer?.fields ?? [];
    this.lengths.replaceChildren(...this.group("scheme lengths", fields.filter((one) => one.kind === "length")));
    this.next.replaceChildren(...this.group("scheme next", fields.filter((one) => one.kind !== "length")));
    if (focused) /** @type {HTMLElement | null} */ (this.element.querySelector(`[data-key="${CSS.escape(focused)}"]`))?.focus();
  }

  /**
   * @param {string[]} errors
   * @param {string} [key] of the value that is refused
   */
  refuse(errors, key = "") {
    const field = key === "" ? null : this.element.querySelector(`[data-key="${CSS.escape(key)}"]`);
    const label = field?.closest("label")?.querySelector("span")?.textContent;
    this.errors.textContent = [label ? `${label}:` : "", ...errors].filter(Boolean).join(" ");
    field?.setAttribute("aria-invalid", "true");
  }

  structureLines() {
    const { answer } = this.editor;
    if (this.editor.waiting > 0 && answer === null) return ["…"];
    if (answer === null) return [element("span", {}, this.editor.say("scheme begin"))];
    this.refuse(answer.errors);
    const lines = [];
    if (answer.mobility !== null) lines.push(element("b", {}, `W = ${answer.mobility < 0 ? "−" : ""}${Math.abs(answer.mobility)}`));
    if (answer.formula !== "") lines.push(element("span", { class: "formula" }, answer.formula));
    if (answer.says !== "") lines.push(element("span", {}, answer.says));
    return lines;
  }

  chosenPart() {
    const { editor } = this;
    const { letter, number } = editor.chosen;
    if (letter !== undefined) {
      const input = /** @type {HTMLInputElement} */ (element("input", { value: letter, maxlength: "4", "data-key": "letter", autocomplete: "off" }));
      input.addEventListener("change", () => input.value !== letter && renameLetter(editor, letter, input.value.trim()));
      const on = bodiesAt(editor.sketch, letter).map((one) => (one === frameOf(editor.sketch) ? editor.say("scheme frame") : String(one.number)));
      return [element("h2", {}, editor.say("scheme pin of", { letter, links: on.join(", ") })), row(editor.say("scheme letter"), input)];
    }
    const body = number === undefined ? undefined : bodyOf(editor.sketch, number);
    if (body === undefined || number === undefined) return [];
    const input = /** @type {HTMLInputElement} */ (element("input", { type: "number", min: "1", max: "999", value: String(number), "data-key": "number" }));
    input.addEventListener("change", () => renameLink(editor, number, Number(input.value)));
    return [element("h2", {}, editor.say("scheme link of", { number, letters: body.points.join(", ") })), row(editor.say("scheme number"), input)];
  }

  /**
   * @param {string} title
   * @param {SchemeField[]} fields
   */
  group(title, fields) {
    const { number } = this.editor.chosen;
    const first = fields.filter((one) => number !== undefined && one.link === number);
    const rest = fields.filter((one) => !first.includes(one));
    return fields.length === 0 ? [] : [element("h2", {}, this.editor.say(title)), ...[...first, ...rest].map((one) => this.field(one))];
  }

  /** @param {SchemeField} field */
  field(field) {
    const { editor } = this;
    const choice = field.choices.length > 0;
    const made = choice ? element("select", { "data-key": field.key }) : element("input", { "data-key": field.key, autocomplete: "off", spellcheck: "false", placeholder: field.placeholder });
    const input = /** @type {HTMLInputElement} */ (made);
    if (choice) input.append(...field.choices.map((one) => element("option", { value: one }, one)));
    input.value = field.text;
    input.disabled = editor.fixed;
    input.addEventListener("change", () => {
      if (input.value !== field.text) this.typed(field, input.value);
    });
    const body = bodyOf(editor.sketch, field.link ?? -1);
    if (body !== undefined) made.addEventListener("focus", () => editor.paper.show(editor.sketch, { number: body.number }));
    return row(field.label, made, field.says);
  }

  /**
   * @param {SchemeField} field
   * @param {string} value
   */
  typed(field, value) {
    const { editor } = this;
    const long = field.kind === "length";
    if (field.name === "") return typeValue(editor, field.key, value, long);
    const question = element("p", { class: "question", role: "alert" }, editor.say("scheme named", { name: field.text }), " ");
    for (const [key, says] of [[field.name, "scheme everywhere"], [field.key, "scheme here"]]) {
      const button = element("button", { type: "button" }, editor.say(says ?? ""));
      button.addEventListener("click", () => typeValue(editor, key ?? "", value, long));
      question.append(button);
    }
    this.errors.replaceChildren(question);
    question.querySelector("button")?.focus();
  }
}

/**
 * @param {string} label
 * @param {HTMLElement} input
 * @param {string} [says]
 */
function row(label, input, says = "") {
  const made = element("label", { class: "scheme-field" }, element("span", { title: says }, label), input);
  return made;
}
