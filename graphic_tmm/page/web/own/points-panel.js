import { element, filled, typeset } from "../dom.js";
import { csvOf, save } from "../practice/record.js";
import { ORIGIN, PlanReadings } from "./readings.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../practice/judging.js").Judged} Judged
 * @typedef {import("./corners.js").OwnPack} OwnPack
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {import("./readings.js").SoughtPoint} SoughtPoint
 */

/** The choice of the plan, its points in turn, what was read of them. */
export class PointsPanel {
  /**
   * @param {Data} data
   * @param {Practice} practice
   * @param {OwnPack} pack
   * @param {() => void} changed another plan or point was chosen
   */
  constructor(data, practice, pack, changed) {
    this.data = data;
    this.practice = practice;
    this.pack = pack;
    this.changed = changed;
    /** By the numbers of the tasks. @type {Map<number, PlanReadings>} */
    this.all = new Map();
    this.task = 0;
    /** @type {SoughtPoint | undefined} */
    this.sought = undefined;
    this.plan = /** @type {HTMLSelectElement} */ (element("select", { "aria-label": this.say("plan") }));
    this.place = /** @type {HTMLSelectElement} */ (element("select", { "aria-label": this.say("position") }));
    const plans = [...new Set(practice.tasks.map((one) => one.plan))];
    this.plan.append(...plans.map((k) => element("option", { value: String(k) }, practice.titles[k] ?? "")));
    this.plan.addEventListener("change", () => this.chosePlan());
    this.place.addEventListener("change", () => this.choose(Number(this.place.value)));
    this.list = element("ol", { class: "own-points", "aria-label": this.say("own points") });
    this.save = /** @type {HTMLButtonElement} */ (element("button", { type: "button" }, this.say("own save")));
    this.save.addEventListener("click", () => this.saved());
    const choice = element("div", { class: "own-plan", role: "group", "aria-label": this.say("own plan") }, this.plan, this.place);
    this.root = element("div", { class: "panel" }, choice, this.list, this.save);
    this.chosePlan();
  }

  /**
   * @param {string} key
   * @param {Record<string, string | number>} values
   */
  say(key, values = {}) {
    return filled(this.data.words[key] ?? key, values);
  }

  /** The readings of the plan that is chosen. */
  get readings() {
    const known = this.all.get(this.task);
    if (known !== undefined) return known;
    const task = /** @type {import("../types.js").Task} */ (this.practice.tasks[this.task]);
    const made = new PlanReadings(this.practice, task);
    this.all.set(this.task, made);
    return made;
  }

  /** The tasks of a plan are its positions; no sheet has a pose. */
  chosePlan() {
    const plan = Number(this.plan.value);
    const tasks = [...this.practice.tasks.entries()].filter(([, one]) => one.plan === plan && !one.pose);
    const name = this.practice.names[this.practice.tasks[this.task]?.at ?? -1];
    this.place.replaceChildren(
      ...tasks.map(([k, one]) => element("option", { value: String(k) }, this.practice.names[one.at] ?? "")),
    );
    const same = tasks.find(([, one]) => this.practice.names[one.at] === name) ?? tasks[0];
    this.place.value = String(same?.[0] ?? 0);
    this.choose(same?.[0] ?? 0);
  }

  /**
   * Go to a plan in a position, by the number of the task.
   * @param {number} task
   */
  choose(task) {
    this.task = task;
    this.seek(this.readings.next);
  }

  /**
   * Ask for a point.
   * @param {SoughtPoint | undefined} point
   */
  seek(point) {
    this.sought = point;
    this.show();
    this.changed();
  }

  /** What was read of the plan that is chosen, judged with all of the drawing. */
  judged() {
    return this.readings.judged(this.all.values());
  }

  /** What is asked for now, in words. */
  get asks() {
    if (this.sought === undefined) return this.say("own all");
    const letter = this.called(this.sought);
    return this.say(this.sought.slot === ORIGIN ? "own origin" : "own point", { letter });
  }

  /** @param {SoughtPoint} point */
  called(point) {
    return point.name || this.say("own nameless");
  }

  /**
   * Take the place of the point that is asked for; return what is told of it.
   * @param {Spot} spot mm on the sheet, y upward
   */
  take(spot) {
    const point = this.sought;
    if (point === undefined) return "";
    this.readings.take(point.slot, spot);
    const judged = this.judged().get(point.slot);
    this.seek(this.readings.next);
    return judged === undefined ? "" : this.told(point, judged);
  }

  /**
   * @param {SoughtPoint} point
   * @param {Judged} judged
   */
  told(point, judged) {
    const [x, y] = (this.readings.figure(point.slot) ?? [NaN, NaN]).map((one) => this.number(one, 1));
    const [verdict, error] = [this.say(`own ${judged.verdict}`), this.number(Math.abs(judged.error), 2)];
    const text = this.say("own verdict", { letter: this.called(point), x: x ?? "", y: y ?? "", verdict, error });
    return judged.follows ? `${text} ${this.say("own follows")}` : text;
  }

  /**
   * @param {number} x
   * @param {number} places
   */
  number(x, places) {
    const digits = { minimumFractionDigits: places, maximumFractionDigits: places };
    return x.toLocaleString(this.data.language, digits).replace("-", "−");
  }

  /** Show what was read, and how it is judged as all stands now. */
  show() {
    const judged = this.judged();
    this.list.replaceChildren(...this.readings.points.map((one) => element("li", {}, this.entry(one, judged.get(one.slot)))));
    this.save.disabled = ![...this.all.values()].some((one) => one.written("").length > 0);
  }

  /**
   * @param {SoughtPoint} point
   * @param {Judged | undefined} judged
   */
  entry(point, judged) {
    const figure = this.readings.figure(point.slot);
    const made = element("button", { type: "button" }, element("b", {}, ...typeset(point.letter || this.called(point))));
    if (figure !== null) {
      made.append(element("span", {}, figure.map((one) => this.number(one, 1)).join("; ")));
    }
    if (judged !== undefined) {
      const verdict = this.say(`own ${judged.verdict}`);
      made.append(element("span", { class: `verdict ${judged.verdict}` }, verdict));
    }
    if (point === this.sought) made.setAttribute("aria-current", "true");
    made.addEventListener("click", (event) => {
      this.seek(point);
      if (event.detail > 0) return;
      /** @type {HTMLElement | null} */ (this.list.querySelector("[aria-current]"))?.focus();
    });
    return made;
  }

  /** The readings of all plans, as a file. */
  get file() {
    const tasks = [...this.all].sort(([a], [b]) => a - b);
    const rows = tasks.flatMap(([, one]) => one.written(this.say("decimal sign")));
    return csvOf(rows, this.say("csv head"), this.say("csv separator"));
  }

  saved() {
    save(`${this.say("own file")}.csv`, this.file, "text/csv");
  }
}
