import { element } from "../../page/web/dom.js";
import { CORNER, clickedPlans, cornersOf, has, together } from "./clicks.js";

/** @typedef {import("./photo-check.js").PhotoCheck} PhotoCheck */
/** @typedef {import("./types.js").Clickable} Clickable */
/** @typedef {import("./types.js").Words} Words */

let count = 0;

/** What stands beside a photograph: which it is, what is clicked next, what was clicked, what its check says. */
export class PhotoSide {
  /**
   * @param {Words} words
   * @param {PhotoCheck} check
   */
  constructor(words, check) {
    this.words = words;
    this.check = check;
    this.file = /** @type {HTMLInputElement} */ (element("input", { type: "file", accept: "image/*" }));
    this.file.hidden = true;
    this.file.addEventListener("change", () => this.chosen());
    this.open = this.button("photo choose", () => this.file.click());
    this.name = element("p", { class: "says" });
    this.of = /** @type {HTMLSelectElement} */ (element("select"));
    this.of.addEventListener("change", () => check.change());
    this.plan = /** @type {HTMLSelectElement} */ (element("select"));
    this.plan.addEventListener("change", () => this.pick());
    this.propose = this.button("photo propose", () => check.propose());
    this.undo = this.button("photo undo", () => check.clicks.undo());
    this.corners = this.button("photo corners", () => check.choose(CORNER));
    this.go = this.button("photo check", () => check.check());
    this.go.classList.add("main");
    this.need = element("p", { class: "says" }, words["photo need"] ?? "");
    this.marks = element("h2", {}, words["photo marks"] ?? "");
    this.rows = element("ul", { class: "clicked" });
    this.wrong = element("div", { class: "wrong" });
    this.result = element("section", { class: "result" });
    this.command = element("code");
    const command = element("details", {}, element("summary", {}, words["photo command"] ?? ""), this.command);
    this.clicking = element(
      "section",
      {},
      this.labelled("photo of", this.of),
      this.propose,
      this.labelled("photo plan", this.plan),
      this.marks,
      this.rows,
      element("div", { class: "row" }, this.undo, this.corners),
      element("p", { class: "says" }, words["photo corners why"] ?? ""),
      this.go,
      this.need,
    );
    this.aim = element("p", { class: "says" }, words["photo aim"] ?? "");
    this.loupe = element("div", { class: "loupe" }, check.desk.loupe.root);
    const head = element("h2", {}, words["photo"] ?? "");
    this.element = element(
      "aside",
      { class: "photo-side", "aria-label": words["photo"] ?? "" },
      element("section", { class: "head" }, element("div", {}, head, this.file, this.open, this.name, this.aim), this.loupe),
      this.wrong,
      this.result,
      this.clicking,
      command,
    );
    this.late = [this.loupe, this.clicking, command];
  }

  /**
   * @param {string} word
   * @param {() => void} act
   */
  button(word, act) {
    const made = /** @type {HTMLButtonElement} */ (element("button", { type: "button" }, this.words[word] ?? ""));
    made.addEventListener("click", act);
    return made;
  }

  /**
   * @param {string} word
   * @param {HTMLElement} input
   */
  labelled(word, input) {
    input.id = `photo-${(count += 1)}`;
    return element("div", { class: "field" }, element("label", { for: input.id }, this.words[word] ?? ""), input);
  }

  /** What is photographed: "paper A4" for a sheet of one's own, "sheet 1" for one as the scene lays it out. */
  get sheet() {
    return this.of.value;
  }

  /** Whether it is a sheet of one's own. */
  get own() {
    return this.sheet.startsWith("paper");
  }

  chosen() {
    const file = this.file.files?.[0];
    if (file) this.check.open(file);
    this.file.value = "";
  }

  /**
   * Offer what may be photographed and clicked.
   * @param {Clickable} told
   */
  offer({ plans, sheets, papers }) {
    const before = this.of.value;
    const own = papers.map((paper) => option(`paper ${paper}`, this.check.say("photo own", { paper })));
    const laid = sheets.map((_, k) => option(`sheet ${k + 1}`, this.check.say("photo sheet", { n: k + 1 })));
    this.of.replaceChildren(...own, ...laid);
    const values = [...this.of.options].map((one) => one.value);
    this.of.value = values.includes(before) ? before : `paper ${sheets[0] ?? papers[0] ?? ""}`;
    const groups = plans.map(({ name, positions }) => {
      const group = element("optgroup", { label: name });
      group.append(...positions.map((position) => option("", position)));
      return group;
    });
    this.plan.replaceChildren(...groups);
  }

  /** Take the plan that a person has chosen: what of it is not clicked yet, else its pole once more. */
  pick() {
    const { check } = this;
    const place = check.clicks.places[this.plan.selectedIndex];
    if (place === undefined) return;
    const first = has(check.clicks.list, place, "pole") && !has(check.clicks.list, place, "first");
    check.choose({ what: first ? "first" : "pole", plan: place.plan, position: place.position });
  }

  /** Whether something went wrong. */
  get troubled() {
    return this.wrong.childElementCount > 0;
  }

  /** @param {string[]} lines what went wrong */
  tell(lines) {
    this.wrong.replaceChildren(...lines.map((line) => element("span", {}, line)));
  }

  show() {
    const { check } = this;
    const { file, clicks } = check;
    const { target, places } = clicks;
    this.open.textContent = check.say(file === null ? "photo choose" : "photo other");
    this.name.textContent = file?.name ?? "";
    for (const one of this.late) one.hidden = file === null || check.coming;
    [...this.plan.options].forEach((one, k) => {
      const place = places[k];
      if (place !== undefined) one.textContent = `${place.name}, ${place.position}${has(clicks.list, place, "pole") ? " ✓" : ""}`;
    });
    this.plan.selectedIndex = places.findIndex((one) => target !== null && together(one, target));
    this.marks.hidden = clicks.list.length === 0;
    this.aim.hidden = clicks.last === null;
    this.undo.disabled = clicks.list.length === 0;
    this.propose.disabled = check.busy;
    this.go.disabled = !check.ready;
    this.need.hidden = check.ready || check.busy;
    this.rows.replaceChildren(...this.clicked());
    this.told();
    const options = check.options.map(([name, value]) => `--${name} ${/[\s]/.test(value) ? `"${value}"` : value}`);
    this.command.textContent = ["graphic-tmm photo", check.scene, `"${file?.name ?? ""}"`, ...options].join(" ");
  }

  /** Return a row for each plan that was clicked, and one for the corners. */
  clicked() {
    const { check } = this;
    const rows = clickedPlans(check.clicks.list).map(({ pole, first }) => {
      const place = check.clicks.placeOf(pole);
      const letters = [place.pole, ...(first === undefined ? [] : [place.first])].join(", ");
      const text = `${place.name}, ${pole.position}: ${letters}`;
      const row = this.row(text, () => check.clicks.remove((one) => together(one, pole)));
      if (first === undefined) {
        const also = this.button("photo also", () => check.choose({ what: "first", plan: pole.plan, position: pole.position }));
        also.textContent = check.say("photo also", { letter: place.first });
        row.insertBefore(also, row.lastChild);
      }
      return row;
    });
    const corners = cornersOf(check.clicks.list).length;
    if (corners === 0) return rows;
    const text = check.say("photo corners row", { n: corners });
    return [...rows, this.row(text, () => check.clicks.remove((one) => one.what === "corner"))];
  }

  /**
   * @param {string} text
   * @param {() => void} act
   */
  row(text, act) {
    const gone = this.button("photo remove", act);
    gone.setAttribute("aria-label", this.check.say("photo remove of", { what: text }));
    return element("li", {}, element("span", {}, text), gone);
  }

  /** Show what the check says. */
  told() {
    const { check } = this;
    const { checked } = check;
    this.result.hidden = checked === null;
    if (checked === null) return;
    const alone = element("a", { href: `report/${checked.page}.html`, target: "_blank", rel: "noopener" }, check.say("photo alone"));
    this.result.replaceChildren(
      element("h2", {}, check.say("photo report")),
      ...(checked.stale ? [element("p", { class: "says" }, check.say("photo stale"))] : []),
      element("p", { class: "summary" }, checked.says),
      ...checked.warnings.map((one) => element("p", { class: "says" }, one)),
      element("div", { class: "row" }, this.button("photo report", () => check.turn(true)), this.button("photo seen", () => check.turn(false))),
      element("p", {}, alone),
    );
  }
}

/**
 * @param {string} value
 * @param {string} text
 */
function option(value, text) {
  return /** @type {HTMLOptionElement} */ (element("option", { value }, text));
}
