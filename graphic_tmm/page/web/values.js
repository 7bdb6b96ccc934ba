import { element, typeset } from "./dom.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Row} Row
 * @typedef {import("./types.js").View} View
 */

/**
 * The small table of a plan in the position that is drawn: it is filled in step by step.
 */
export class ValuesTable {
  /**
   * @param {Data} data
   * @param {View} view
   * @param {Map<number, number>} made in which stop each mark is made
   */
  constructor(data, view, made) {
    this.view = view;
    this.made = made;
    this.words = data.words;
    this.place = "";
    this.body = element("tbody");
    this.caption = element("caption");
    const heads = ["segment", "length", "scale", "quantity"].map((key) =>
      element("th", { scope: "col" }, this.words[key] ?? key),
    );
    this.table = element("table", { class: "values" }, this.caption, element("thead", {}, element("tr", {}, ...heads)));
    this.table.append(this.body);
  }

  /**
   * Show the table at a stop: rows of what is drawn and read by then; no table before there is one.
   * @param {number} n
   */
  show(n) {
    const view = this.view;
    const picture = view.pictures[Math.min(n, view.pictures.length - 1)];
    const place = String(picture?.at ?? view.first);
    const rows = view.values[place] ?? [];
    if (place !== this.place) {
      this.place = place;
      this.body.replaceChildren(...rows.map((row) => rowOf(row)));
      const name = view.position || (view.names[place] ?? "");
      const called = this.words["values"] ?? "";
      this.caption.textContent = name === "" ? called : `${called}, ${this.words["in position"]} ${name}`;
    }
    const stops = rows.map((row) => this.made.get(row[0][0] ?? -1) ?? 0);
    this.table.hidden = stops.every((stop) => stop > n);
    stops.forEach((stop, k) => {
      const part = this.body.children[k];
      part?.toggleAttribute("hidden", stop > n);
      part?.classList.toggle("now", stop === n && n > 0);
    });
  }
}

/**
 * @param {Row} row
 */
function rowOf([slots, segment, mm, mu, value, quantity]) {
  const letter = element("th", { scope: "row" }, ...typeset(segment));
  const worth = quantity === "" ? [value] : [...typeset(quantity), ` = ${value}`];
  const cells = [[mm], [mu === "" ? "" : `× ${mu}`], worth].map((inner) => element("td", {}, ...inner));
  return element("tr", { "data-of": slots.join(" ") }, letter, ...cells);
}
