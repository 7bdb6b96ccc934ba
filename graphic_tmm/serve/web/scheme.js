import { element } from "../../page/web/dom.js";
import { themeButton } from "../../page/web/theme.js";
import { Editor } from "./scheme/editor.js";
import { Memory } from "./scheme/memory.js";
import { keepSeen } from "./scheme/seen.js";
import { blankSketch } from "./scheme/sketch.js";
import { about, newScene, schemeAfter } from "./wire.js";

/** @typedef {import("./types.js").DrawingPaper} DrawingPaper */

/** @type {DrawingPaper} */
const paper = about();
const { words } = paper;
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
const head = /** @type {HTMLElement} */ (document.getElementById("head"));
const told = /** @type {HTMLElement} */ (document.getElementById("told"));
/** Where what is drawn is kept until it is a scene. */
const MEMORY = "scheme";

/** @param {string} text */
function tell(text) {
  if (told.textContent !== text) told.textContent = text;
}

const editor = new Editor(words, (act) => schemeAfter("scheme", act), tell);
editor.follow = () => {
  save.disabled = editor.text === "";
  try {
    sessionStorage.setItem(MEMORY, JSON.stringify({ sketch: editor.sketch, text: editor.text }));
  } catch {
    // a browser may keep nothing
  }
};
const title = /** @type {HTMLInputElement} */ (element("input", { maxlength: "80", placeholder: words["scheme title"] ?? "", "aria-label": words["scheme title"] ?? "" }));
const save = /** @type {HTMLButtonElement} */ (element("button", { type: "submit", class: "main" }, words["scheme save"] ?? ""));
const form = element("form", { class: "scheme-save" }, title, save);
form.addEventListener("submit", async (event) => {
  event.preventDefault();
  await editor.queue;
  if (editor.text === "") return tell(words["scheme not whole"] ?? "");
  const { name, errors } = await newScene(editor.text, title.value);
  if (name === "") return tell(errors[0] ?? words["not sent"] ?? "");
  sessionStorage.removeItem(MEMORY);
  const place = new URL(`s/${encodeURIComponent(name)}/#scheme`, location.href);
  keepSeen(editor, place.pathname);
  await memory.moveTo(place.pathname);
  location.assign(place.href);
});
if (paper.several) head.prepend(element("a", { href: "./" }, words["scenes"] ?? ""));
head.append(themeButton(words));
main.replaceChildren(editor.element, element("aside", { "aria-label": words["scheme"] ?? "" }, form, editor.side.element));
document.documentElement.classList.add("js");
save.disabled = true;
const { text, sketch } = remembered();
const memory = new Memory(editor);
editor.begin(text, sketch).then(() => memory.recall());

/** @returns {{text: string, sketch: import("./types.js").Sketch}} */
function remembered() {
  try {
    const kept = JSON.parse(sessionStorage.getItem(MEMORY) ?? "null");
    if (kept?.sketch?.links?.length > 1) return kept;
  } catch {
    // what is kept is of no use
  }
  return { text: "", sketch: blankSketch() };
}
