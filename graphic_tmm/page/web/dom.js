/** @typedef {import("./types.js").Run} Run */

export const SVG = "http://www.w3.org/2000/svg";

/**
 * Return an element with attributes and what stands in it; text is text.
 * @param {string} name
 * @param {Record<string, string>} attributes
 * @param {(Node | string)[]} inner
 * @returns {HTMLElement}
 */
export function element(name, attributes = {}, ...inner) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...inner);
  return made;
}

/**
 * Return an SVG element with attributes.
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {Node[]} inner
 * @returns {SVGElement}
 */
export function drawnElement(name, attributes = {}, ...inner) {
  const made = /** @type {SVGElement} */ (document.createElementNS(SVG, name));
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...inner);
  return made;
}

/**
 * Return mark-up as nodes: v_{BA} has an index, a^{n} stands raised, an index may have its own.
 * @param {string} markup
 * @returns {(Node | string)[]}
 */
export function typeset(markup) {
  /** @type {(Node | string)[][]} */
  const open = [[]];
  const names = [];
  for (const piece of markup.split(/([_^]\{|\})/)) {
    if (piece === "_{" || piece === "^{") {
      names.push(piece === "_{" ? "sub" : "sup");
      open.push([]);
    } else if (piece === "}" && names.length > 0) {
      const inner = open.pop() ?? [];
      open.at(-1)?.push(element(names.pop() ?? "sub", {}, ...inner));
    } else if (piece !== "") {
      open.at(-1)?.push(piece);
    }
  }
  return open.flat();
}

/**
 * Return a sentence as nodes; a letter bears the slot of its mark.
 * @param {Run[]} runs
 * @returns {(Node | string)[]}
 */
export function sentenceOf(runs) {
  return runs.flatMap((run) =>
    typeof run === "string"
      ? typeset(run)
      : [element("span", { class: "letter", "data-of": String(run[1]) }, ...typeset(run[0]))],
  );
}

/**
 * Return a template with its names filled in.
 * @param {string} template
 * @param {Record<string, string | number>} values
 */
export function filled(template, values) {
  return template.replace(/\{(\w+)\}/g, (_, name) => String(values[name] ?? ""));
}

/**
 * Return a button with an icon (path data in a box of 24) and its name.
 * @param {string} icon
 * @param {string} name
 * @param {() => void} act
 */
export function iconButton(icon, name, act) {
  const made = element("button", { type: "button", class: "icon", "aria-label": name, title: name });
  const picture = drawnElement("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" });
  picture.append(drawnElement("path", { d: icon }));
  made.append(picture);
  made.addEventListener("click", act);
  return made;
}
