import { stepBar } from "./bar.js";
import { chooser } from "./chooser.js";
import { element, filled, iconButton } from "./dom.js";
import { closeIn, enlarge } from "./enlarge.js";
import { groupOf } from "./equation.js";
import { enterFull, hearFull, isFull, leaveFull } from "./full.js";
import { insetOf } from "./inset.js";
import { listenToKeys } from "./keys.js";
import { toggle } from "./run.js";
import { Speaker } from "./speaker.js";
import { Stage } from "./stage.js";
import { tellingOf } from "./telling.js";
import { turnTheme } from "./theme.js";
import { Tools } from "./tools.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

const SIGNS = {
  full: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  speaker: "M3 4h18v12H3zM8 20h8M12 16v4",
  black: "M4 4h16v16H4z",
};
/** Letters of the drawing, as a share of the window's height. */
const LETTERS = 1 / 30;
/** What is told stands in letters of so many hundredths of the height, the largest that leave room; then without why. */
const SIZES = [5.2, 4.8, 4.4, 4];
/** Without a movement of the pointer for so long the buttons are put away on a full screen, ms. */
const AWAKE = 3000;

/**
 * Build the way of looking for a lecture: one plan, large, what is told beside it.
 * @param {Data} data
 * @param {State} state
 * @returns {HTMLElement}
 */
export function lectureRoom(data, state) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const paper = element("div", { class: "paper" });
  const title = element("h2", {});
  const count = element("p", { class: "count" });
  const heads = element("div", { class: "heads" });
  const telling = element("div", { class: "telling" });
  const black = element("div", { class: "black", hidden: "" });
  const trouble = element("p", { class: "hint", role: "alert", hidden: "" });
  /** @type {Stage | null} */
  let stage = null;
  /** @type {Tools | null} */
  let tools = null;
  /** @type {ReturnType<typeof insetOf>} */
  let inset = null;

  const full = button("full", "full screen", () => (isFull() ? leaveFull(dressed) : enterFull(dressed)));
  const dressed = (/** @type {boolean} */ on) => {
    wake();
    full.title = say(on ? "leave full screen" : "full screen");
    full.setAttribute("aria-label", full.title);
    full.querySelector("span")?.replaceChildren(full.title);
  };
  const turnBlack = (to = black.hidden) => {
    black.hidden = !to;
  };
  const talk = () => {
    trouble.textContent = speaker.open() ? "" : say("no window");
    trouble.hidden = trouble.textContent === "";
  };
  /**
   * @param {keyof typeof SIGNS} sign
   * @param {string} key
   * @param {() => void} act
   */
  function button(sign, key, act) {
    const made = iconButton(SIGNS[sign], say(key), act);
    if (sign !== "black") made.querySelector("path")?.classList.add("line");
    made.append(element("span", {}, say(key)));
    return made;
  }

  function fit() {
    if (stage === null || paper.clientWidth === 0) return;
    if (!closed.has(stage)) closeIn(stage.svg);
    closed.add(stage);
    enlarge(stage.svg, Math.max(window.innerHeight * LETTERS, 14));
    const room = /** @type {HTMLElement} */ (telling.parentElement);
    for (const brief of [false, true]) {
      room.classList.toggle("brief", brief);
      for (const size of SIZES) {
        room.style.setProperty("--share", String(size));
        if (room.scrollHeight <= room.clientHeight) return;
      }
    }
  }
  /** @type {WeakSet<Stage>} */
  const closed = new WeakSet();
  new ResizeObserver(fit).observe(paper);

  state.hear((place, before) => {
    if (place.tab !== "lecture") {
      leaveFull(dressed);
      return turnBlack(false);
    }
    if (data.views.length === 0) return;
    if (place.picture !== before.picture || place.view !== before.view) turnBlack(false);
    if (stage?.view !== state.view) {
      stage = new Stage(state.view);
      title.textContent = state.view.title;
      paper.replaceChildren(stage.svg);
      fit();
      tools = new Tools(stage.svg, state.view);
      inset = insetOf(data, state.view, stage.svg, paper);
    }
    stage.show(place.picture);
    tools?.show(place.picture);
    inset?.show(place.picture);
    count.textContent = filled(say("step of"), { step: place.picture, count: state.view.pictures.length });
    heads.replaceChildren(...groupOf(state.view, place.picture));
    telling.replaceChildren(...tellingOf(data, state.view, place.picture));
    fit();
  });

  const turn = (/** @type {number} */ by) => () => state.go({ view: state.place.view + by, picture: 0 });
  const keys = {
    ArrowDown: turn(1),
    ArrowUp: turn(-1),
    Home: () => state.go({ picture: 0 }),
    End: () => state.go({ picture: Infinity }),
    p: () => toggle(state),
    b: () => turnBlack(),
    ".": () => turnBlack(),
    d: turnTheme,
  };
  const speaker = new Speaker(data, state, keys);
  listenToKeys(state, "lecture", {
    ...speaker.keys,
    f: () => full.click(),
    s: talk,
    Escape: () => leaveFull(dressed),
  });
  hearFull(dressed);

  const aids = element(
    "div",
    { class: "lecture-aids" },
    button("speaker", "speaker", talk),
    button("black", "black", () => turnBlack()),
    full,
  );
  const bar = element("div", { class: "lecture-bar" }, stepBar(data, state), chooser(data, state), aids);
  const told = element("div", { class: "saying", tabindex: "0" }, title, count, heads, telling);
  const room = element("section", { id: "lecture", class: "awake" }, paper, told, trouble, bar, black);
  let timer = 0;
  function wake() {
    room.classList.add("awake");
    window.clearTimeout(timer);
    timer = window.setTimeout(() => room.classList.remove("awake"), AWAKE);
  }
  room.addEventListener("pointermove", wake);
  black.addEventListener("click", () => turnBlack(false));
  return room;
}
