import { filled } from "../dom.js";
import { LENGTHS } from "../lengths.js";
import { Bench } from "./bench.js";
import { Easel } from "./easel.js";
import { keep, kept } from "./kept.js";
import { isCrossed } from "./matching.js";
import { csvOf, save } from "./record.js";
import { Task } from "./task.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("./record.js").Reading} Reading
 * @typedef {import("./task.js").Tried} Tried
 * @typedef {import("./score.js").Mark} Mark
 * @typedef {[number, Tried | null, Mark, number]} Kept a step that is done: its mark, as it was told, what it was worth, its help
 */

/** A task as it is worked on: its board, what is done of it, kept beyond the page where the browser allows that. */
export class Session {
  /**
   * @param {Data} data
   * @param {number} n number of the task
   * @param {typeof LENGTHS.given} [given] otherwise than in the scene
   */
  constructor(data, n, { values, says } = LENGTHS.given) {
    this.data = data;
    const practice = /** @type {Practice} */ (data.practice);
    this.practice = { ...practice, given: { ...practice.given, ...Object.fromEntries(values) } };
    this.says = says;
    this.told = /** @type {import("../types.js").Task} */ (this.practice.tasks[n]);
    this.name = [data.title, this.practice.plans[this.told.plan], this.position, this.told.steps.join(" "), ...(says === "" ? [] : [says])].join(", ");
    this.bench = new Bench(this.practice, this.told);
    this.easel = new Easel(this.practice, this.told, this.bench, data.words);
    this.task = this.taskOf();
    this.exact = this.easel.exact();
    this.frame = this.easel.frame();
    this.restore(kept(this.name));
  }

  /** The name of the position. */
  get position() {
    return this.practice.names[this.told.at] ?? "";
  }

  /** The view of the mechanism as the scene gives it. */
  get lead() {
    return this.says === "" ? this.data.views.find((view) => view.joints !== undefined) : undefined;
  }

  /** The view that shows the mechanism, if that is not drawn itself. */
  get mechanism() {
    const { lead } = this;
    return lead?.plan === this.practice.plans[this.told.plan] ? undefined : lead;
  }

  /** The view that shows the mechanism, if that is to be drawn. */
  get given() {
    return this.mechanism === undefined ? this.lead : undefined;
  }

  /** The task in words. */
  get goal() {
    const own = this.says === "" ? "" : ` ${filled(this.data.words["practised"] ?? "", { values: this.says })}`;
    return `${this.told.goal}${own}`;
  }

  taskOf() {
    const moves = this.told.steps.flatMap((slot) => this.easel.steps.get(slot) ?? []);
    const { easel } = this;
    return new Task(this.bench, moves, {
      kindOf: (slot) => easel.kindOf(slot),
      isScale: (slot) => easel.isScale(slot),
      isHere: (slot) => easel.isHere(slot),
    }, (this.told.free ?? []).flatMap((slot) => this.easel.steps.get(slot) ?? []));
  }

  /** Begin anew. */
  clear() {
    this.bench = new Bench(this.practice, this.told);
    this.easel.bench = this.bench;
    this.task = this.taskOf();
    this.keep();
  }

  keep() {
    const { task } = this;
    /** @type {Kept[]} */
    const done = [...task.results].map(([slot, tried]) => [slot, tried, task.score.marks.get(slot) ?? "helped", task.helped.get(slot) ?? 0]);
    keep(this.name, { done, tries: task.tries });
  }

  /**
   * Go on where it was left; what cannot be read is let go.
   * @param {any} left
   */
  restore(left) {
    try {
      for (const [slot, tried, mark, help] of /** @type {Kept[]} */ (left?.done ?? [])) {
        const there = this.bench.ready(slot) || isCrossed(this.easel.steps.get(slot));
        if (!this.task.own.has(slot) || !there) break;
        this.task.take(slot, tried);
        this.task.score.marks.set(slot, mark);
        this.task.helped.set(slot, help);
      }
      this.task.tries = left?.tries ?? [];
    } catch {
      this.clear();
    }
  }

  /**
   * Return what was drawn as rows of a check: what its readings have a name for.
   * @returns {Reading[]}
   */
  readings() {
    return [...this.task.results].map(([slot, tried]) => this.row(slot, tried)).filter((row) => row !== null);
  }

  /**
   * @param {number} slot
   * @param {Tried | null} tried
   * @returns {Reading | null}
   */
  row(slot, tried) {
    const read = this.easel.steps.get(slot)?.read;
    if (read === undefined || tried === null) return null;
    const [first = "", second = ""] = tried.texts;
    const row = { plan: read.name, position: this.position, segment: read.key };
    if (read.as === "point") return { ...row, x: first, y: second };
    return read.as === "length" ? { ...row, mm: first } : { ...row, value: first, unit: read.unit || "1" };
  }

  /** Return all that was done, as data. */
  record() {
    const { easel, task, practice } = this;
    const drawn = task.free.filter((move) => task.isDone(move.it));
    const steps = [...task.moves, ...drawn].map((move) => ({
      step: easel.markOf(move.it).n,
      by: move.op,
      worth: task.score.marks.get(move.it) ?? null,
      help: task.helped.get(move.it) ?? 0,
      tries: task.tries.filter((one) => one.slot === move.it).map(({ texts, error, verdict }) => ({ told: texts, error, verdict })),
    }));
    const [plan, position] = [practice.plans[this.told.plan], this.position];
    const own = this.says === "" ? {} : { given: this.says };
    return { scene: this.data.title, ...own, plan, position, hand: practice.hand, score: task.score.tally(), steps };
  }

  /** What files of the task are called. */
  get file() {
    const words = [this.data.title, this.practice.plans[this.told.plan], this.position, this.says].join(" ");
    return words.replace(/[^\p{L}\p{N}]+/gu, "-").toLowerCase();
  }

  saveRecord() {
    save(`${this.file}.json`, JSON.stringify(this.record(), null, 1), "application/json");
  }

  saveReadings() {
    const { words } = this.data;
    save(`${this.file}.csv`, csvOf(this.readings(), words["csv head"] ?? "", words["csv separator"] ?? ","), "text/csv");
  }
}

/** The tasks as they are worked on, with what is given now. */
export class Sessions {
  /** @param {Data} data */
  constructor(data) {
    this.data = data;
    this.given = LENGTHS.given;
    /** @type {Map<number, Session>} */
    this.begun = new Map();
  }

  /**
   * Take what is given otherwise than in the scene: the log runs with it. Tell whether that is news.
   * @param {typeof LENGTHS.given} given
   */
  give(given) {
    if (given === this.given) return false;
    this.given = given;
    this.begun.clear();
    return true;
  }

  /** @param {number} n number of a task */
  of(n) {
    const held = this.begun.get(n) ?? new Session(this.data, n, this.given);
    this.begun.set(n, held);
    return held;
  }
}
