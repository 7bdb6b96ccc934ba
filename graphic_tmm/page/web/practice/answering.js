import { element, filled, typeset } from "../dom.js";
import { cellOf, numberOf, shownNumber } from "./typed.js";

/**
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {(key: string) => string} Say
 */

/**
 * Return the form in which a figure is told: a length in mm, a rate in its unit.
 * @param {Say} say
 * @param {string} decimal
 * @param {(value: number, text: string) => void} tell
 * @param {(trouble: string) => void} refuse
 */
export function figureForm(say, decimal, tell, refuse) {
  const field = /** @type {HTMLInputElement} */ (fieldOf("figure"));
  const name = element("label", { for: field.id });
  const unit = element("span", { class: "unit" });
  const form = formOf(say("judge"), () => {
    const value = numberOf(field.value);
    if (Number.isNaN(value)) refuse(filled(say("no number"), { example: `47${decimal}3` }));
    else tell(value, cellOf(field.value, decimal));
  });
  form.prepend(name, field, unit);
  return {
    form,
    field,
    /**
     * @param {string} letter
     * @param {string} of the unit
     */
    begin(letter, of) {
      name.replaceChildren(...typeset(letter), " = ");
      unit.textContent = of;
      field.value = "";
    },
  };
}

/**
 * Return the form in which a place is told by its coordinates; it follows the cross.
 * @param {Say} say
 * @param {string} decimal
 * @param {(spot: Spot) => void} aim
 * @param {() => void} prick
 */
export function spotForm(say, decimal, aim, prick) {
  const fields = ["x", "y"].map((axis) => /** @type {HTMLInputElement} */ (fieldOf(axis)));
  const labels = fields.map((field) => element("label", { for: field.id }, field.id.at(-1) ?? ""));
  const from = element("span", { class: "unit" });
  const read = () => {
    const found = fields.map((field) => numberOf(field.value));
    if (!found.some(Number.isNaN)) aim([found[0] ?? 0, found[1] ?? 0]);
  };
  for (const field of fields) field.addEventListener("input", read);
  const form = formOf(say("mark it"), prick);
  form.prepend(...fields.flatMap((field, k) => [labels[k] ?? "", field]), from);
  return {
    form,
    /** @param {string} letter of where the coordinates begin */
    begin(letter) {
      const [before = "", after = ""] = say("coordinates").split("{letter}");
      from.replaceChildren(before, ...typeset(letter), after);
    },
    /** @param {Spot} spot */
    show(spot) {
      fields.forEach((field, k) => {
        if (document.activeElement !== field) field.value = shownNumber(spot[k] ?? 0, 2, decimal);
      });
    },
  };
}

/** @param {string} name */
function fieldOf(name) {
  return element("input", { id: `practice-${name}`, type: "text", inputmode: "text", autocomplete: "off", size: "7" });
}

/**
 * @param {string} told what its button is called
 * @param {() => void} act
 */
function formOf(told, act) {
  const form = element("form", { class: "answer", hidden: "" }, element("button", { type: "submit" }, told));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    act();
  });
  return form;
}
