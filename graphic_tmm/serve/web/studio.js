import { element, filled } from "../../page/web/dom.js";
import { themeButton } from "../../page/web/theme.js";
import { Faults } from "./faults.js";
import { Values } from "./form.js";
import { PageFrame } from "./frame.js";
import { agrees } from "./scheme/agrees.js";
import { takeOwn } from "./scheme/editor-acts.js";
import { Editor } from "./scheme/editor.js";
import { Memory } from "./scheme/memory.js";
import { keepSeen } from "./scheme/seen.js";
import { PhotoCheck } from "./photo-check.js";
import { Sheets } from "./sheets.js";
import { tabList } from "./tabs.js";
import { about, drawAgain, follow, schemeAfter, setValues } from "./wire.js";

/** @typedef {import("./types.js").State} State */
/** @typedef {import("./types.js").Studio} Studio */

/** @type {Studio} */
const scene = about();
const { words } = scene;
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
const head = /** @type {HTMLElement} */ (document.getElementById("head"));
const told = /** @type {HTMLElement} */ (document.getElementById("told"));
/** How a scene stands when nothing is wrong with it. */
const QUIET = ["", "drawing", "drawn"];
/** Where the way of looking, and the place in the page, are remembered while the page is loaded anew. */
const MEMORY = `studio ${location.pathname}`;
const { way = "", place = "" } = remembered();

const DONE = 200,
  OUTDATED = 409;
/** What a scheme is asked of that is the file's, whatever was known of it. */
const THE_FILE = { text: "", version: "" };

/** @type {State | null} */
let state = null;
let linked = true;
let lost = false;
/** What was said last of how the scene stands. */
let stood = "";

const sheets = new Sheets(words);
const frame = new PageFrame(words, place, drawAgain, scene.fixed ? null : putOwn);
const values = new Values(
  words,
  scene.fixed,
  tell,
  (form) => {
    const title = form.groups.flatMap((group) => group.fields).find((field) => field.key === "title")?.text;
    document.title = title || scene.name;
    const heading = head.querySelector("h1");
    if (heading !== null) heading.textContent = document.title;
    if (state !== null) faults.show(state.errors, state.warnings);
  },
);
const photo = new PhotoCheck(words, scene.name, tell);
// where nothing is to be said of the scheme, it is how the scene stands
const scheme = new Editor(words, sendScheme, (text) => tell(text || stood), scene.fixed);
const memory = new Memory(scheme);
/** What is drawn of how the scene could be, beside its scheme. */
const waysOut = element("div", { class: "faults" });
/** The version of the file that the scheme shows; "": none yet. */
let schemed = "";
/** The way of looking that was chosen. */
let looked = "";
const faults = new Faults(
  words,
  (key) => values.has(key),
  (key) => values.go(key),
  scene.fixed ? null : (chosen) => void choose(chosen),
);

const again = element("button", { type: "button", class: "again" }, words["again"] ?? "");
again.addEventListener("click", drawAgain);
again.hidden = true;
told.after(again);

/**
 * Write values that were chosen together into the file, whatever else it says by now.
 * @param {Record<string, string>} changes
 */
async function choose(changes) {
  let answer = await setValues(values.version, changes);
  if (answer.status === OUTDATED && (await values.load())) answer = await setValues(values.version, changes);
  if (answer.status === DONE) values.version = answer.version;
  else tell(answer.errors.map((one) => one.text).join(" ") || (words["not sent"] ?? ""));
}

/** Say something that is read aloud as well. @param {string} text */
function tell(text) {
  if (told.textContent !== text) told.textContent = text;
}

/** How the scene stands: the name of the words that say it. */
function standing() {
  if (!linked) return "lost";
  if (state === null) return "";
  if (state.busy) return "drawing";
  if (state.ok) return "drawn";
  if (state.failed !== "") return state.fresh ? "failed page" : "failed";
  if (state.fresh) return "faults page";
  return state.sheets.length > 0 ? "faults" : "faults first";
}

/** Say how the scene stands, if it is another way than before. */
function tellState() {
  const stands = standing();
  const text = filled(words[stands] ?? "", { n: state?.errors.length ?? 0, why: state?.failed ?? "" });
  // a photograph that is worked on keeps its line while nothing is wrong with the scene
  if (text !== stood) tell(QUIET.includes(stands) ? photo.standing || text : text);
  stood = text;
  document.body.classList.toggle("lost", stands === "lost");
  document.body.classList.toggle("busy", stands === "drawing");
  document.body.classList.toggle("faulty", (state?.errors.length ?? 0) > 0);
  again.hidden = stands !== "failed" && stands !== "failed page";
}

/** @param {State} now */
function hear(now) {
  state = now;
  sheets.show(now.sheets);
  frame.show(now);
  faults.show(now.errors, now.warnings);
  waysOut.replaceChildren(...now.errors.flatMap((one) => faults.pictures(one)));
  values.follow(now.text_version);
  photo.follow(now.text_version);
  if (now.text_version !== schemed && looked === "scheme" && scheme.waiting === 0) loadScheme();
  tellState();
}

/**
 * Send an act on the scheme; if the file has changed meanwhile, do it on what the file is now, unless both changed the same.
 * @param {import("./types.js").SchemeAct} act
 * @returns {Promise<import("./types.js").SchemeTold>}
 */
async function sendScheme(act) {
  const answer = await schemeAfter("scheme", { version: schemed, ...act });
  if (answer.status !== OUTDATED) {
    schemed = answer.answer?.version ?? schemed;
    return answer;
  }
  const now = await schemeAfter("scheme", { ...THE_FILE, at: scheme.answer?.at ?? null });
  if (now.answer === null) return now;
  schemed = now.answer.version;
  const newer = now.answer;
  if (!agrees(act, scheme.answer, newer)) return { ...answer, answer: null, errors: [words["scheme changed"] ?? ""], newer };
  return { newer, ...(await sendScheme({ ...act, text: newer.text ?? "" })) };
}

/**
 * Put values that were changed in the page into the file, where the scheme can take them back; say how that ended.
 * @param {string} own
 */
async function putOwn(own) {
  if (schemed === "" || state?.text_version !== schemed) await scheme.reload(THE_FILE);
  const [why] = await takeOwn(scheme, own);
  return why ?? words["own put"] ?? "";
}

/** Show the scheme of the file as it is. */
function loadScheme() {
  void scheme.reload(THE_FILE).then(() => memory.recall());
}

/** @param {boolean} there */
function link(there) {
  if (there && lost) tell(words["mended"] ?? "");
  const changed = linked !== there;
  linked = there;
  lost = !there;
  if (changed) tellState();
}

function files() {
  const links = scene.downloads.map(({ form, name }) =>
    element("li", {}, element("a", { href: `download/${form}`, download: "" }, name)),
  );
  return element("section", { class: "files" }, element("h2", {}, words["files"] ?? ""), element("ul", {}, ...links));
}

function remember() {
  if (schemed !== "") keepSeen(scheme);
  try {
    const now = { way: looked, place: frame.place };
    sessionStorage.setItem(MEMORY, JSON.stringify(now));
  } catch {
    // a browser may keep nothing
  }
}

/** @returns {{way?: string, place?: string}} */
function remembered() {
  try {
    return JSON.parse(sessionStorage.getItem(MEMORY) ?? "{}");
  } catch {
    return {};
  }
}

/** @param {string} name of a way of looking */
function look(name) {
  looked = name;
  frame.look(name === "page");
  photo.look(name === "photo");
  side.hidden = name === "photo" || name === "scheme";
  photo.side.element.hidden = name !== "photo";
  schemeSide.hidden = name !== "scheme";
  if (name === "scheme" && (schemed === "" || state?.text_version !== schemed)) loadScheme();
}

const ways = [
  { name: "sheets", title: words["sheets"] ?? "", panel: sheets.element },
  { name: "scheme", title: words["scheme"] ?? "", panel: scheme.element },
  { name: "page", title: words["page"] ?? "", panel: frame.element },
  ...(scene.photographed ? [{ name: "photo", title: words["photo"] ?? "", panel: photo.element }] : []),
];
const side = element("aside", { "aria-label": words["values"] ?? "" }, faults.element, values.element, files());
const schemeSide = element("aside", { "aria-label": words["scheme"] ?? "" }, waysOut, scheme.side.element);
if (scene.several) head.prepend(element("a", { href: "../../" }, words["scenes"] ?? ""));
main.replaceChildren(...ways.map(({ panel }) => panel), side, schemeSide, photo.side.element);
const theme = themeButton(words);
theme.addEventListener("click", () => frame.dress());
head.append(tabList(words["ways"] ?? "", ways, location.hash.slice(1) || way, look), theme);
document.documentElement.classList.add("js");
window.addEventListener("pagehide", remember);
follow("events", hear, link);
