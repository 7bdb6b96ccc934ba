import { element } from "../../../page/web/dom.js";
import { renameLetter, renameLink, typeValue } from "./editor-acts.js";
import { arrange, Row } from "./rows.js";
import { SectionForm } from "./section-form.js";
import { bodiesAt, bodyOf, frameOf } from "./sketch.js";

/**
 * What is said beside the paper: what the mechanism is and lacks, the chosen pin or link, lengths, and what the task
 * gives next.
 *
 * @typedef {import("../types.js").SchemeField} SchemeField
 * @typedef {import("./editor.js").Editor} Editor
 */

/** One quantity, and two of one unit with no blank between: the second was typed behind the first, and for it. */
const PLAIN = /^[+\-−]?[\d.,]+\s*\p{L}*$/u;
const GLUED = /\d\s*(\p{L}+)[+\-−][\d.,]+\s*\1\s*$/u;

/** What the two choices of a switch are called. @type {Record<string, string>} */
const SWITCHED = { true: "on", false: "off" };

export class Side {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    this.structure = element("p", { class: "structure" });
    this.chosen = element("div", { class: "chosen-part" });
    this.lengths = element("div", { class: "lengths" });
    this.next = element("div", { class: "next" });
    this.errors = element("p", { class: "wrong", role: "alert" });
    this.more = new SectionForm(editor);
    this.how = element("details", { class: "how" }, element("summary", {}, editor.say("scheme how")), element("p", {}, editor.say("scheme how text")), element("p", {}, editor.say("scheme keys")));
    this.element = element("div", { class: "scheme-side" }, this.structure, this.errors, this.chosen, this.lengths, this.next, this.more.element, this.how);
    /** Why the last act was refused that was no value typed here. @type {string[]} */
    this.refused = [];
    /** @type {Map<string, Row>} */
    this.rows = new Map();
    /** @type {Map<string, HTMLElement>} */
    this.titles = new Map();
    this.shown = "";
  }

  show() {
    const { editor } = this;
    const { answer, chosen, sketch } = editor;
    this.structure.replaceChildren(...this.structureLines());
    this.complain();
    this.more.show(answer?.sections ?? []);
    const fields = answer?.fields ?? [];
    this.rows = new Map(fields.map((one) => [one.key, this.row(one)]));
    arrange(this.lengths, this.group("scheme lengths", fields.filter((one) => one.kind === "length")));
    arrange(this.next, this.group("scheme next", fields.filter((one) => one.kind !== "length")));
    const state = JSON.stringify([chosen, sketch.links, sketch.drives]);
    if (state === this.shown) return;
    this.shown = state;
    const focused = document.activeElement?.getAttribute("data-key");
    this.chosen.replaceChildren(...this.chosenPart());
    if (focused) /** @type {HTMLElement | null} */ (this.chosen.querySelector(`[data-key="${CSS.escape(focused)}"]`))?.focus();
  }

  /** @param {string[]} errors why an act was refused; none: it was not */
  refuse(errors) {
    this.refused = errors;
    this.complain();
  }

  /** Say what is wrong: with the scene, with the last act, with what stands in a field. */
  complain() {
    const typed = [...this.rows.values()].flatMap(({ field, refused }) => (refused.length > 0 ? [`${field.label}:`, ...refused] : []));
    const text = [...(this.editor.answer?.errors ?? []), ...this.refused, ...typed].join(" ");
    if (this.errors.textContent !== text) this.errors.textContent = text;
  }

  structureLines() {
    const { answer } = this.editor;
    if (this.editor.waiting > 0 && answer === null) return ["…"];
    if (answer === null) return [element("span", {}, this.editor.say("scheme begin"))];
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
      return [element("h2", {}, editor.say("scheme pin of", { letter, links: on.join(", ") })), labelled(editor.say("scheme letter"), input)];
    }
    const body = number === undefined ? undefined : bodyOf(editor.sketch, number);
    if (body === undefined || number === undefined) return [];
    const input = /** @type {HTMLInputElement} */ (element("input", { type: "number", min: "1", max: "999", value: String(number), "data-key": "number" }));
    input.addEventListener("change", () => renameLink(editor, number, Number(input.value)));
    return [element("h2", {}, editor.say("scheme link of", { number, letters: body.points.join(", ") })), labelled(editor.say("scheme number"), input)];
  }

  /**
   * @param {string} title
   * @param {SchemeField[]} fields
   */
  group(title, fields) {
    const { number } = this.editor.chosen;
    const first = fields.filter((one) => number !== undefined && one.link === number);
    const rest = fields.filter((one) => !first.includes(one));
    const rows = [...first, ...rest].flatMap(({ key }) => this.rows.get(key)?.elements ?? []);
    return rows.length === 0 ? [] : [this.title(title), ...rows];
  }

  /** @param {string} key */
  title(key) {
    const made = this.titles.get(key) ?? element("h2", {}, this.editor.say(key));
    this.titles.set(key, made);
    return made;
  }

  /**
   * Return the row of a field, the one that is there if there is one.
   * @param {SchemeField} field
   */
  row(field) {
    const { editor } = this;
    const there = this.rows.get(field.key);
    if (there !== undefined && there.field.choices.join() === field.choices.join()) {
      there.set(field);
      return there;
    }
    return new Row(field, editor.fixed, (choice) => editor.say(SWITCHED[choice] ?? choice), {
      typed: (row) => this.typed(row),
      refused: () => this.complain(),
      focused: ({ link }) => bodyOf(editor.sketch, link ?? -1) && editor.paper.show(editor.sketch, { number: link ?? undefined }),
    });
  }

  /** @param {Row} row */
  typed(row) {
    const { editor } = this;
    const { field } = row;
    const value = row.input.value;
    if (PLAIN.test(field.text) && GLUED.test(value)) return row.refuse([editor.say("scheme glued")]);
    const send = (/** @type {string} */ key) => void row.send(typeValue(editor, key, value, field.kind === "length"));
    if (field.name === "") return send(field.key);
    // the first length is the scale of all
    if (!editor.measured && field.kind === "length") return send(field.name);
    const question = element("p", { class: "question", role: "alert" }, editor.say("scheme named", { name: field.text }), " ");
    for (const [key, says] of [[field.name, "scheme everywhere"], [field.key, "scheme here"]]) {
      const button = element("button", { type: "button" }, editor.say(says ?? ""));
      button.addEventListener("click", () => send(key ?? ""));
      question.append(button);
    }
    row.ask(question);
  }
}

/**
 * @param {string} label
 * @param {HTMLElement} input
 */
function labelled(label, input) {
  return element("label", { class: "scheme-field" }, element("span", {}, label), input);
}
