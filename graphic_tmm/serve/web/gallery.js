import { element, filled } from "../../page/web/dom.js";
import { themeButton } from "../../page/web/theme.js";
import { about, follow } from "./wire.js";

/** @typedef {import("./types.js").Gallery} Gallery */
/** @typedef {import("./types.js").State} State */

/** @type {Gallery} */
const folder = about();
const { words } = folder;
const head = /** @type {HTMLElement} */ (document.getElementById("head"));
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
const told = /** @type {HTMLElement} */ (document.getElementById("told"));

/** @type {Map<string, {picture: HTMLElement, state: HTMLElement, hash: string}>} */
const cards = new Map();

/**
 * Return what a scene is opened by: the picture of its first sheet, what it is, how it stands.
 * @param {string} name
 * @param {string} title
 */
function card(name, title) {
  const picture = element("div", { class: "picture" });
  const state = element("p", { class: "stands" }, words["waiting"] ?? "");
  const link = element("a", { href: `s/${encodeURIComponent(name)}/` }, picture, element("h2", {}, title));
  if (title !== name) link.append(element("p", { class: "name" }, name));
  cards.set(name, { picture, state, hash: "" });
  return element("li", { class: "card" }, link, state);
}

/** @param {State} state */
function stands(state) {
  if (state.errors.length > 0) return filled(words["scene faults"] ?? "", { n: state.errors.length });
  if (state.failed !== "" && !state.fresh) return filled(words["failed"] ?? "", { why: state.failed });
  if (state.sheets.length === 0) return words["waiting"] ?? "";
  return words["fine"] ?? "";
}

/** @param {State} state */
function hear(state) {
  const shown = cards.get(state.name ?? "");
  if (shown === undefined) return;
  shown.state.textContent = stands(state);
  shown.state.classList.toggle("wrong", state.errors.length > 0);
  const hash = state.sheets[0]?.hash ?? "";
  if (hash === shown.hash || hash === "") return;
  shown.hash = hash;
  const made = new Image();
  made.alt = "";
  made.addEventListener("load", () => shown.picture.replaceChildren(made));
  made.src = `s/${encodeURIComponent(state.name ?? "")}/sheet/${hash}.svg`;
}

head.append(themeButton(words));
if (!folder.fixed) head.append(element("a", { href: "draw" }, words["scheme draw"] ?? ""));
main.replaceChildren(
  folder.scenes.length === 0
    ? element("p", { class: "hint" }, words["no scenes"] ?? "")
    : element("ul", { class: "cards" }, ...folder.scenes.map(({ name, title }) => card(name, title))),
);
document.documentElement.classList.add("js");
follow("events", hear, (there) => {
  told.textContent = there ? "" : (words["lost"] ?? "");
});
