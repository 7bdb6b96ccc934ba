import { drawnElement, element, filled } from "../../page/web/dom.js";

/** @typedef {import("./types.js").Fault} Fault */
/** @typedef {import("./types.js").Picture} Picture */
/** @typedef {import("./types.js").Words} Words */

/** What is wrong with the file, line by line, and what is to be known of what was drawn. */
export class Faults {
  /**
   * @param {Words} words
   * @param {(key: string) => boolean} has whether there is a field of a key
   * @param {(key: string) => void} go to the field of a key
   * @param {((values: Record<string, string>) => void) | null} choose write values; null where the file stays
   */
  constructor(words, has, go, choose) {
    this.words = words;
    this.has = has;
    this.go = go;
    this.choose = choose;
    this.told = "";
    this.element = element("section", { class: "faults" });
    this.element.hidden = true;
  }

  /**
   * @param {Fault[]} errors
   * @param {string[]} warnings
   */
  show(errors, warnings) {
    const told = JSON.stringify([errors, warnings, errors.map((one) => this.has(one.key))]);
    if (told === this.told) return;
    this.told = told;
    this.element.hidden = errors.length + warnings.length === 0;
    this.element.replaceChildren();
    if (errors.length > 0) {
      const list = element("ol", {}, ...errors.map((one) => this.fault(one)));
      this.element.append(element("h2", {}, this.words["faults head"] ?? ""), list);
    }
    if (warnings.length > 0) {
      const list = element("ul", {}, ...warnings.map((one) => element("li", {}, one)));
      this.element.append(element("h2", {}, this.words["warnings head"] ?? ""), list);
    }
  }

  /** @param {Fault} fault */
  fault(fault) {
    const made = element("li", { class: "fault" });
    const line = fault.line > 0 ? filled(this.words["line"] ?? "", { line: fault.line }) : "";
    const place = [line, fault.place || fault.key].filter((one) => one !== "").join(" · ");
    if (this.has(fault.key)) {
      const button = element("button", { type: "button", class: "place" }, place);
      button.addEventListener("click", () => this.go(fault.key));
      made.append(button);
    } else if (place !== "") {
      made.append(element("strong", {}, place));
    }
    if (fault.source) made.append(element("code", {}, fault.source));
    made.append(element("p", {}, fault.text));
    made.append(...this.pictures(fault));
    return made;
  }

  /**
   * Return the ways out of a fault that are drawn, if it has any and the file may change.
   * @param {Fault} fault
   */
  pictures({ pictures = [] }) {
    if (this.choose === null || pictures.length === 0) return [];
    return [element("div", { class: "pictures" }, ...pictures.map((one) => this.picture(one)))];
  }

  /**
   * A way out drawn small; a click writes it.
   * @param {Picture} one
   */
  picture({ lines, values }) {
    const says = Object.entries(values).map(([key, text]) => `${key.replace(/^.*, /, "")} = ${text}`);
    const picture = drawnElement("svg", { viewBox: "-0.05 -0.05 1.1 1.1", "aria-hidden": "true" });
    for (const line of lines) picture.append(drawnElement("polyline", { points: line.join(" ") }));
    const button = element("button", { type: "button" });
    button.append(picture, element("span", {}, says[0] ?? ""));
    button.title = says.join(", ");
    button.addEventListener("click", () => this.choose?.(values));
    return button;
  }
}
