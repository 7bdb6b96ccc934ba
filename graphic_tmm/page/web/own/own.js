import { element, filled } from "../dom.js";
import { percent } from "../sheet-size.js";
import { Aim } from "./aim.js";
import { cornerChoice } from "./corners.js";
import { ExactPlans } from "./exact.js";
import { findingsOf } from "./findings.js";
import { layFlat } from "./laying.js";
import { OwnDesk } from "./own-desk.js";
import { openedPhoto } from "./photo.js";
import { PointsPanel } from "./points-panel.js";
import { orderedCorners } from "./projection.js";
import { ORIGIN } from "./readings.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../state.js").State} State
 * @typedef {import("./own-desk.js").Sign} Sign
 * @typedef {import("./corners.js").OwnPack} OwnPack
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {import("./laying.js").LaidFlat} LaidFlat
 */

const OWN_TAB = "own";
/** How strongly the exact plan is seen at first, of 100. */
const STRONG = 50;

/**
 * Build the way of looking in which a person's own sheet lies under the exact plan, and its points are read.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function ownRoom(data, state) {
  const { own: pack, practice } = data;
  if (pack === undefined || practice === undefined) return element("section", {});
  return new OwnRoom(data, state, pack, practice).root;
}

class OwnRoom {
  /**
   * @param {Data} data
   * @param {State} state
   * @param {OwnPack} pack
   * @param {Practice} practice
   */
  constructor(data, state, pack, practice) {
    this.data = data;
    this.pack = pack;
    this.state = state;
    this.exact = new ExactPlans(data);
    /** @type {Exclude<Awaited<ReturnType<typeof openedPhoto>>, string> | null} */
    this.photo = null;
    /** @type {Spot[]} */
    this.corners = [];
    /** @type {LaidFlat | null} */
    this.flat = null;
    /** Which of the things that take time is the last one that was begun. */
    this.begun = 0;
    const surface = element("div", { class: "desk", tabindex: "0", role: "application", "aria-label": this.say("own desk") });
    this.desk = new OwnDesk(surface);
    this.aim = new Aim(state, OWN_TAB, this.desk, this.say("own loupe"));
    this.aim.onAim = () => this.show();
    this.aim.onTake = () => this.take();
    this.panel = new PointsPanel(data, practice, pack, () => this.follow());
    this.choice = cornerChoice(data, pack, (key, values) => this.say(key, values), () => this.again());
    this.message = element("p", { class: "own-told" }, this.say("own drop"));
    this.strength = /** @type {HTMLInputElement} */ (
      element("input", { type: "range", min: "0", max: "100", value: String(STRONG) })
    );
    this.strength.addEventListener("input", () => this.show());
    this.root = this.built(surface);
    state.hear((place) => {
      if (place.tab === OWN_TAB) this.desk.measure();
    });
  }

  /**
   * @param {string} key
   * @param {Record<string, string | number>} values
   */
  say(key, values = {}) {
    return filled(this.data.words[key] ?? key, values);
  }

  /** @param {HTMLElement} surface */
  built(surface) {
    const file = /** @type {HTMLInputElement} */ (element("input", { type: "file", accept: "image/*,.pdf,.heic,.tif,.tiff", class: "unseen", tabindex: "-1", "aria-hidden": "true" }));
    file.addEventListener("change", () => {
      const [chosen] = file.files ?? [];
      if (chosen !== undefined) void this.open(chosen);
      file.value = "";
    });
    const choose = element("button", { type: "button", class: "begin" }, this.say("own choose"));
    choose.addEventListener("click", () => file.click());
    this.anew = element("button", { type: "button" }, this.say("own again"));
    this.anew.addEventListener("click", () => this.again());
    this.anew.hidden = true;
    const take = element("button", { type: "button", class: "own-take" }, this.say("own take"));
    take.addEventListener("click", () => this.aim.take());
    this.aim.loupe.root.append(take);
    this.over = element("label", {}, this.say("own exact"), " ", this.strength);
    this.over.hidden = true;
    this.panel.root.hidden = true;
    const bar = element("div", { class: "bar" }, choose, file, this.choice.root, this.anew, this.over);
    const section = element("section", { class: "own" }, bar, surface, this.aim.loupe.root, this.message, this.panel.root);
    section.addEventListener("dragover", (event) => event.preventDefault());
    section.addEventListener("drop", (event) => {
      event.preventDefault();
      const [dropped] = event.dataTransfer?.files ?? [];
      if (dropped !== undefined) void this.open(dropped);
    });
    return section;
  }

  /**
   * Tell something, aloud too.
   * @param {string} text
   */
  tell(text) {
    this.message.textContent = text;
    const live = document.getElementById("live");
    if (live !== null) live.textContent = text;
  }

  /** @param {Blob} file */
  async open(file) {
    const now = (this.begun += 1);
    this.tell(this.say("own opening"));
    const found = await openedPhoto(file);
    if (now !== this.begun) return;
    if (typeof found === "string") return this.tell(this.say(found));
    this.photo = found;
    this.again();
  }

  /** Ask for the corners. */
  again() {
    this.begun += 1;
    this.corners = [];
    this.flat = null;
    if (this.photo === null) return;
    const { picture } = this.photo;
    this.desk.lay({ picture, width: picture.width, height: picture.height });
    this.aim.through({ picture, shot: null, left: 0, top: 0 }, !this.rough);
    this.asks();
    this.show();
    this.desk.surface.focus();
  }

  /** Whether corners may be clicked roughly: the frame has lines that are found. */
  get rough() {
    return this.choice.chosen().sheet >= 0;
  }

  asks() {
    this.tell(this.say(this.rough ? "own corner" : "own corner fine", { n: this.corners.length + 1 }));
  }

  /** What is aimed at is taken: a corner, a point. */
  take() {
    const { spot } = this.aim;
    if (spot === null) return;
    this.aim.clear();
    if (this.flat !== null) {
      const told = this.panel.take(this.flat.shot.onSheet(...spot));
      return this.tell(`${told} ${this.panel.asks}`);
    }
    this.corners.push(spot);
    this.show();
    if (this.corners.length < 4) return this.asks();
    void this.lay();
  }

  /** Lay the photograph flat by its corners. */
  async lay() {
    const ordered = orderedCorners(this.corners);
    if (this.photo === null) return;
    if (ordered === null) {
      this.again();
      return this.tell(`${this.say("own no corners")} ${this.message.textContent ?? ""}`);
    }
    const now = (this.begun += 1);
    const of = this.choice.chosen();
    const told = (/** @type {number} */ share) =>
      (this.message.textContent = this.say("own flattening", { percent: percent(Math.round(100 * share) / 100, this.data.language) }));
    const found = await layFlat(this.photo.image, ordered, of, this.pack, told, () => now === this.begun);
    if (found === null) return;
    this.flat = found;
    const [left, , , top] = of.area;
    this.desk.lay({ picture: found.picture, width: found.width, height: found.height });
    this.aim.through({ picture: this.photo.picture, shot: found.shot, left, top }, true);
    this.show();
    this.tell([...findingsOf(found, ordered, this.pack, this.panel), this.panel.asks].join(" "));
  }

  /** Another plan or point was chosen. */
  follow() {
    if (this.flat === null) return;
    this.aim.clear();
    this.show();
    this.tell(this.panel.asks);
  }

  /** Show what is there: the corners or the points, the exact plan over them. */
  show() {
    const laid = this.flat !== null;
    if (this.anew !== undefined) this.anew.hidden = this.photo === null;
    if (this.over !== undefined) this.over.hidden = !laid;
    this.panel.root.hidden = !laid;
    this.root?.classList.toggle("laid", laid);
    this.root?.classList.toggle("opened", this.photo !== null);
    this.desk.upon = this.upon();
    this.desk.signs = laid ? this.signs() : this.corners.map((one) => ({ at: this.aim.onDesk(one), name: "", sign: "corner" }));
    if (this.aim.spot !== null) this.desk.signs.push({ at: this.aim.onDesk(this.aim.spot), name: "", sign: "aim" });
    this.desk.moved();
  }

  /** The exact plan with its pole on the pole that was read: nobody sets out a sheet as this one is. */
  upon() {
    const opacity = Number(this.strength.value) / 100;
    if (this.flat === null || opacity === 0) return null;
    const { area } = this.flat.of;
    const { task, spots } = this.panel.readings;
    const origin = spots.get(ORIGIN);
    if (origin === undefined) return null;
    const [x, y] = [origin[0] - area[0] - task.origin[0], area[3] - origin[1] - task.origin[1]];
    return { path: this.exact.plan(task), x, y, opacity };
  }

  /** @returns {Sign[]} */
  signs() {
    const { readings } = this.panel;
    const judged = this.panel.judged();
    const [left, , , top] = this.flat?.of.area ?? [0, 0, 0, 0];
    return readings.points.flatMap((point) => {
      const spot = readings.spots.get(point.slot);
      if (spot === undefined) return [];
      const sign = point.slot === ORIGIN ? "origin" : (judged.get(point.slot)?.verdict ?? "fine");
      return [{ at: [spot[0] - left, top - spot[1]], name: point.name, sign }];
    });
  }
}
