/** @typedef {import("./field.js").FieldView} FieldView */

/**
 * Show the fields that have what is sought in their key or their sentence, their sections open; all, if nothing is.
 * @param {string} sought
 * @param {FieldView[]} views
 * @param {HTMLElement} groups
 * @param {Map<string, boolean>} opened what a person opened or closed, by the name of the section
 */
export function show(sought, views, groups, opened) {
  const text = sought.trim().toLowerCase();
  for (const view of views) {
    const { key, says } = view.field;
    view.element.hidden = !`${key} ${says}`.toLowerCase().includes(text);
  }
  for (const one of groups.querySelectorAll("details")) {
    const found = one.querySelector(".field:not([hidden])") !== null;
    const { name, open } = one.dataset;
    one.hidden = !found;
    one.open = text === "" ? (opened.get(name ?? "") ?? open === "true") : found;
  }
}
