import { element, filled } from "../../page/web/dom.js";
import { Clicks, clickedPlans, cornersOf, optionsOf } from "./clicks.js";
import { PhotoDesk } from "./photo-desk.js";
import { PhotoSide } from "./photo-side.js";
import { checkPhoto, plansOf, proposePlans } from "./wire.js";

/** @typedef {import("./types.js").Checked} Checked */
/** @typedef {import("./types.js").Click} Click */
/** @typedef {import("./types.js").Spot} Spot */
/** @typedef {import("./types.js").Target} Target */
/** @typedef {import("./types.js").Words} Words */

const MOST_BYTES = 60e6;

/** A photograph of a drawing: its plans clicked, checked by the server, the report beside it. */
export class PhotoCheck {
  /**
   * @param {Words} words
   * @param {string} scene its name
   * @param {(text: string) => void} tell
   */
  constructor(words, scene, tell) {
    this.words = words;
    this.scene = scene;
    /** What was said last. */
    this.last = "";
    this.tell = (/** @type {string} */ text) => tell((this.last = text));
    this.clicks = new Clicks(() => this.change());
    /** @type {File | null} */
    this.file = null;
    /** @type {Checked | null} */
    this.checked = null;
    this.busy = false;
    /** Of the text of the scene that there is, and of that whose plans are known. */
    this.version = "";
    this.loaded = "";
    this.coming = true;
    this.seen = false;
    this.desk = new PhotoDesk(words, {
      place: (spot) => this.clicks.place(spot),
      move: (spot) => this.clicks.move(spot),
      undo: () => this.clicks.undo(),
    });
    this.side = new PhotoSide(words, this);
    this.prompt = element("p", { class: "prompt" });
    this.drop = element("p", { class: "hint drop" }, words["photo drop"] ?? "");
    this.desk.desk.append(this.drop);
    this.report = document.createElement("iframe");
    this.report.title = words["photo report"] ?? "";
    this.report.hidden = true;
    this.bar = element("div", { class: "prompt-bar" }, this.prompt, this.desk.tools);
    this.element = element("div", { class: "photo" });
    this.element.addEventListener("dragover", (event) => event.preventDefault());
    this.element.addEventListener("drop", (event) => this.dropped(event));
    this.turn(false);
    this.show();
  }

  /**
   * Return what is said somewhere.
   * @param {string} word
   * @param {Record<string, string | number>} values
   */
  say(word, values = {}) {
    return filled(this.words[word] ?? "", values);
  }

  /**
   * Take notice of the text of the scene: its plans may be others.
   * @param {string} version
   */
  follow(version) {
    this.version = version;
    this.load();
  }

  /** @param {boolean} seen */
  look(seen) {
    this.seen = seen;
    if (seen && this.element.childElementCount === 0) this.element.append(this.bar, this.desk.desk);
    this.load();
    if (seen) this.desk.size();
  }

  async load() {
    if (!this.seen || this.loaded === this.version) return;
    const { version } = this;
    this.loaded = version;
    const told = await plansOf();
    if (this.loaded !== version) return;
    if (told === null) {
      this.loaded = "";
      return;
    }
    this.coming = told.errors.length > 0;
    if (!this.coming) {
      this.clicks.offer(told.plans);
      this.side.offer(told);
    }
    this.side.tell(told.errors);
    this.change();
  }

  /** @param {DragEvent} event */
  dropped(event) {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) this.open(file);
  }

  /** @param {File} file */
  async open(file) {
    const fine = file.size <= MOST_BYTES && (await this.desk.open(file));
    if (!fine) {
      const text = this.say(file.size > MOST_BYTES ? "photo large" : "photo unread", { name: file.name });
      this.side.tell([text]);
      return this.tell(text);
    }
    this.file = file;
    this.checked = null;
    this.side.tell([]);
    this.drop.hidden = true;
    this.clicks.clear();
    this.desk.desk.focus();
  }

  /** @param {Target} target */
  choose(target) {
    this.clicks.choose(target);
    this.change();
    this.desk.desk.focus();
  }

  /** Something was clicked, or is to be: what was checked before is of other clicks. */
  change() {
    if (this.checked !== null) this.checked = { ...this.checked, marks: [], stale: true };
    this.turn(false);
    this.show();
    if (this.file !== null && this.seen) this.tell(this.asked());
  }

  show() {
    this.prompt.textContent = this.file === null ? "" : this.asked();
    const { list, last } = this.clicks;
    const marks = list.map((click) => ({ spot: click.spot, text: this.lettered(click), kind: click.what }));
    const seen = (this.checked?.marks ?? []).map(({ x, y, text, verdict }) => ({
      spot: /** @type {Spot} */ ([x, y]),
      text,
      kind: `seen ${verdict || "unsure"}`,
    }));
    this.desk.show([...marks, ...seen], last === null ? null : (marks[list.indexOf(last)] ?? null));
    this.side.show();
  }

  /** What a person is asked to click. */
  asked() {
    const { target, places, list } = this.clicks;
    if (this.coming) return this.say(this.side.troubled ? "photo failed" : "drawing");
    if (!this.side.own && list.length === 0 && this.clicks.chosen === null) return this.say("photo laid");
    if (target === null) return this.say(places.length > 0 ? "photo every" : "photo none");
    if (target.what === "corner") {
      return this.say(this.side.own ? "photo paper" : "photo frame", { n: cornersOf(list).length + 1 });
    }
    const { name, position, ...place } = this.clicks.placeOf(target);
    return this.say(target.what === "pole" ? "photo pole" : "photo first", { letter: place[target.what], plan: name, position });
  }

  /** @param {Click} click */
  lettered(click) {
    if (click.what === "corner") return String(cornersOf(this.clicks.list).indexOf(click) + 1);
    return `${this.clicks.placeOf(click)[click.what]} ${click.position}`;
  }

  /** What was said last of the photograph that is worked on; "" where none is. */
  get standing() {
    return this.seen && this.file !== null ? this.last : "";
  }

  /** Whether there is something to be checked. */
  get ready() {
    const clicked = clickedPlans(this.clicks.list).length > 0;
    return this.file !== null && !this.busy && (clicked || !this.side.own);
  }

  /** The options of the command `photo` that say the same. */
  get options() {
    return optionsOf(this.clicks.list, this.side.sheet);
  }

  async check() {
    const asked = this.options;
    const found = await this.send(checkPhoto, asked);
    if (found === null) return;
    const { file, answer } = found;
    const stale = JSON.stringify(asked) !== JSON.stringify(this.options) || file !== this.file;
    this.clicks.last = null;
    this.checked = answer === null ? null : { ...answer, stale, marks: stale ? [] : answer.marks };
    if (answer !== null) {
      if (!this.report.isConnected) this.element.append(this.report);
      this.report.src = `report/${answer.page}.html`;
      this.tell(this.say("photo done"));
    }
    this.turn(this.checked !== null);
    this.show();
    this.side.element.scrollTop = 0;
  }

  /** Have plans looked for in the photograph; they are to be confirmed. */
  async propose() {
    const found = await this.send(proposePlans, this.options);
    if (found === null) return;
    const { file, answer } = found;
    if (answer === null || file !== this.file) return this.show();
    this.clicks.take(answer.plans);
    this.tell(this.say("photo looked", { n: answer.plans.length }));
    this.prompt.textContent = this.last;
  }

  /**
   * Send the photograph, and what was clicked; null if there is none, or one is being read.
   * @template T
   * @param {(file: Blob, asked: [string, string][]) => Promise<{answer: T | null, errors: string[]}>} ask
   * @param {[string, string][]} asked
   */
  async send(ask, asked) {
    const { file } = this;
    if (file === null || this.busy) return null;
    this.busy = true;
    this.side.tell([]);
    this.show();
    this.prompt.textContent = this.say("photo begun");
    this.tell(this.say("photo begun"));
    const { answer, errors } = await ask(file, [["name", file.name], ...asked]);
    this.busy = false;
    if (answer === null) {
      this.side.tell(errors.length > 0 ? errors : [this.say("photo failed")]);
      this.tell(this.say("photo failed"));
      this.side.element.scrollTop = 0;
    }
    return { file, answer };
  }

  /** Show the report, or the photograph. @param {boolean} report */
  turn(report) {
    this.report.hidden = !report;
    this.desk.desk.hidden = report;
    this.bar.hidden = report || this.file === null;
    if (!report) this.desk.size();
  }
}
