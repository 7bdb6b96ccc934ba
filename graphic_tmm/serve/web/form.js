import { element, filled } from "../../page/web/dom.js";
import { FieldView, mould } from "./field.js";
import { show } from "./seek.js";
import { formOf, setValues } from "./wire.js";

/** @typedef {import("./types.js").Answer} Answer */
/** @typedef {import("./types.js").Field} Field */
/** @typedef {import("./types.js").Form} Form */
/** @typedef {import("./types.js").Group} Group */
/** @typedef {import("./types.js").Words} Words */

const DONE = 200;
const OUTDATED = 409;
const REFUSED = 422;

/** The values of the scene, by section; each is written into the file for itself. */
export class Values {
  /**
   * @param {Words} words
   * @param {boolean} fixed whether they can only be read
   * @param {(text: string) => void} tell
   * @param {(form: Form) => void} heard what is to be done when the file has other values
   */
  constructor(words, fixed, tell, heard) {
    this.words = words;
    this.fixed = fixed;
    this.tell = tell;
    this.heard = heard;
    this.version = "";
    this.shape = "";
    /** @type {Map<string, FieldView>} */
    this.views = new Map();
    /** What was opened or closed by a person, by its title. @type {Map<string, boolean>} */
    this.opened = new Map();
    this.waiting = Promise.resolve();
    this.sought = element("input", { type: "search", "aria-label": words["find"] ?? "", placeholder: words["find"] ?? "" });
    this.sought.addEventListener("input", () => this.seek());
    this.nothing = element("p", { class: "hint" }, words["no form"] ?? "");
    this.nothing.hidden = true;
    this.groups = element("div", { class: "groups" });
    const keys = element("p", { class: "says" }, words[fixed ? "fixed" : "form keys"] ?? "");
    const head = element("h2", {}, words["values"] ?? "");
    this.element = element("section", { class: "values" }, head, keys, this.nothing, this.sought, this.groups);
  }

  /** @param {string} key */
  has(key) {
    return this.near(key) !== undefined;
  }

  /** The field of a key; of a point its first coordinate, of a table its first value. @param {string} key */
  near(key) {
    if (key === "") return undefined;
    const within = [`${key}[`, `${key}.`, `${key}, `];
    const inner = [...this.views.keys()].find((one) => within.some((begin) => one.startsWith(begin)));
    return this.views.get(key) ?? this.views.get(inner ?? "");
  }

  /**
   * Go to a field.
   * @param {string} key
   */
  go(key) {
    const input = this.near(key)?.input;
    for (let up = input?.closest("details"); up; up = up.parentElement?.closest("details")) up.open = true;
    input?.focus();
  }

  /**
   * Take notice of the version that the file has.
   * @param {string} version
   */
  follow(version) {
    this.behind(async () => {
      if (version !== this.version || !this.nothing.hidden) await this.load();
    });
  }

  /**
   * Do something behind all that is still being done.
   * @param {() => Promise<void>} act
   */
  behind(act) {
    this.waiting = this.waiting.then(act);
  }

  /** Take the values that the file has; whether it has any. */
  async load() {
    const form = await formOf();
    this.nothing.hidden = form !== null;
    if (form === null) return false;
    this.version = form.version;
    this.show(form);
    this.heard(form);
    return true;
  }

  /**
   * Show values; where only they changed, the fields stay.
   * @param {Form} form
   */
  show(form) {
    const fields = form.groups.flatMap((group) => group.fields);
    const shape = JSON.stringify(form.groups.map((group) => [group.title, group.fields.map(mould)]));
    const told = fields.filter((field) => this.views.get(field.key)?.overtaken(field));
    if (shape === this.shape) for (const field of fields) this.views.get(field.key)?.set(field);
    else this.arrange(form, fields, shape);
    for (const field of told) {
      const view = this.views.get(field.key);
      if (view?.changed) this.conflict(view);
    }
  }

  /**
   * Put fields where they belong, with what is typed in them, what is open and who has the focus.
   * @param {Form} form
   * @param {Field[]} fields
   * @param {string} shape
   */
  arrange(form, fields, shape) {
    this.shape = shape;
    const before = this.views;
    const focused = [...before.values()].find((view) => view.input === document.activeElement);
    const back = focused?.hold();
    this.views = new Map(fields.map((field) => [field.key, this.view(field, before.get(field.key))]));
    this.groups.replaceChildren(...form.groups.map((group, k) => this.group(group, k === 0)));
    this.seek();
    if (focused !== undefined) back?.(this.views.get(focused.field.key));
  }

  /**
   * Return a field's view, the one before where it can stay: what is typed there stays with it.
   * @param {Field} field
   * @param {FieldView | undefined} before
   */
  view(field, before) {
    const same = before !== undefined && JSON.stringify(mould(before.field)) === JSON.stringify(mould(field));
    if (same) {
      before.set(field);
      return before;
    }
    const made = new FieldView(this.words, field, this.fixed, (view) => this.behind(() => this.save(view)));
    if (before?.changed) made.input.value = before.input.value;
    return made;
  }

  /**
   * Return a section with its fields: first those that the file has.
   * @param {Group} group
   * @param {boolean} open
   */
  group(group, open) {
    const elements = (/** @type {Field[]} */ fields) =>
      fields.flatMap((field) => this.views.get(field.key)?.element ?? []);
    const there = group.fields.filter((field) => field.written || field.wanted);
    const others = group.fields.filter((field) => !there.includes(field));
    const made = this.details(group.title, group.title, open && group.there);
    made.classList.toggle("absent", !group.there);
    made.append(element("p", { class: "says" }, group.says), ...elements(there));
    if (others.length > 0 && there.length > 0) {
      const more = this.details(`${group.title}/`, this.words["more"] ?? "", false);
      more.append(...elements(others));
      made.append(more);
    } else {
      made.append(...elements(others));
    }
    return made;
  }

  /**
   * @param {string} name
   * @param {string} title
   * @param {boolean} open
   */
  details(name, title, open) {
    const made = document.createElement("details");
    const summary = element("summary", {}, title);
    made.dataset["name"] = name;
    made.dataset["open"] = String(open);
    made.open = this.opened.get(name) ?? open;
    summary.addEventListener("click", () => this.opened.set(name, !made.open));
    made.append(summary);
    return made;
  }

  seek() {
    show(/** @type {HTMLInputElement} */ (this.sought).value, [...this.views.values()], this.groups, this.opened);
  }

  /**
   * Write what was typed into the file; once more, if only other values of it have changed meanwhile.
   * @param {FieldView} view
   * @param {boolean} again
   */
  async save(view, again = false) {
    const { key, text, place } = view.field;
    const typed = view.input.value;
    if (typed === text) return;
    const answer = await setValues(this.version, { [key]: typed });
    if (answer.status === DONE) {
      this.version = answer.version;
      this.views.get(key)?.accept(typed);
      this.tell(filled(this.words["written"] ?? "", { key: place || key }));
    } else if (answer.status === OUTDATED) {
      await this.overtaken(view, again);
    } else {
      this.refuse(this.views.get(key) ?? view, answer);
    }
  }

  /**
   * Look at the file that was changed meanwhile: whether it has another value there, or a value at all.
   * @param {FieldView} view
   * @param {boolean} again
   */
  async overtaken(view, again) {
    const { key, text } = view.field;
    const there = await this.load();
    const now = this.views.get(key);
    if (now === undefined) return;
    if (!there) now.tell([this.words["no form"] ?? ""]);
    else if (now.field.text === text && !again) await this.save(now, true);
    else this.conflict(now);
  }

  /** @param {FieldView} view */
  conflict(view) {
    const text = view.field.text === "" ? (this.words["nothing there"] ?? "") : view.field.text;
    const says = filled(this.words["conflict"] ?? "", { text });
    view.tell([says]);
    this.tell(says);
  }

  /**
   * @param {FieldView} view
   * @param {Answer} answer
   */
  refuse(view, answer) {
    const { key, place } = view.field;
    const lines = answer.errors.map((one) => (one.key === key || one.key === "" ? one.text : `${one.place || one.key}: ${one.text}`));
    const refused = answer.status === REFUSED && lines.length > 0;
    view.tell(refused ? lines : [this.words["not sent"] ?? ""]);
    this.tell(filled(this.words["refused"] ?? "", { key: place || key }));
  }
}
