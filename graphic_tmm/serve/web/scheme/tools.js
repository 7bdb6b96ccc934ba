import { element } from "../../../page/web/dom.js";
import { doAgain, removeChosen, takeBack } from "./editor-acts.js";

/**
 * The row of tools above the paper.
 *
 * @typedef {import("./editor.js").Editor} Editor
 * @typedef {import("./tool-acts.js").ToolName} Tool
 */

/** The tools in their order, with what each is drawn as (24 × 24), what it is called, how it is used. @type {[Tool, string, string, string][]} */
const TOOLS = [
  ["support", "M12 5L5 17H19ZM5 17l-2 3M10 17l-2 3M15 17l-2 3M20 17l-2 3", "scheme support", "scheme do support"],
  ["slider", "M2 17H22M5 17l-2 3M10 17l-2 3M15 17l-2 3M20 17l-2 3M6 8H18V15H6Z", "scheme slider", "scheme do slider"],
  ["stone", "M3 21L21 3M7 11L13 5L19 11L13 17Z", "scheme stone", "scheme do stone"],
  ["cylinder", "M3 9H15V15H3ZM9 9V15M9 12H22", "scheme cylinder", "scheme do cylinder"],
  ["point", "M3 19L21 19L12 5ZM12 5m-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0", "scheme point", "scheme do point"],
  ["centre", "M12 3a9 9 0 1 0 .01 0M12 3V21M3 12H21", "scheme centre", "scheme do centre"],
  ["drive", "M19 12A7 7 0 1 1 12 5M9 2L13 5L9 8", "scheme drive", "scheme do drive"],
  ["weld", "M4 20L12 6L20 20M9 11.5L12 6L15 11.5Z", "scheme weld", "scheme do weld"],
  ["passive", "M4 20L9 5M20 20L15 5M9 5H15M12 8V11M12 14V17M12 20V21", "scheme passive", "scheme do passive"],
];

/**
 * Return the name of the words that say how a tool is used.
 * @param {string} tool
 */
export function howOf(tool) {
  return TOOLS.find(([one]) => one === tool)?.[3] ?? "";
}

export class ToolBar {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    this.element = element("div", { class: "scheme-tools", role: "toolbar", "aria-label": editor.say("scheme tools") });
    /** @type {Map<string, HTMLElement>} */
    this.buttons = new Map();
    this.putTools();
  }

  putTools() {
    const { editor } = this;
    for (const [tool, icon, name] of TOOLS) {
      this.put(tool, icon, editor.say(name), () => {
        editor.hand.take(editor.hand.tool === tool ? "" : tool);
        editor.paper.svg.focus({ preventScroll: true });
      });
    }
    this.put("undo", "M9 7L4 12L9 17M4 12H15A5 5 0 0 1 15 22", editor.say("scheme undo"), () => takeBack(editor), true);
    this.put("redo", "M15 7L20 12L15 17M20 12H9A5 5 0 0 0 9 22", editor.say("scheme redo"), () => doAgain(editor), true);
    this.put("delete", "M5 7H19M9 7V4H15V7M7 7L8 21H16L17 7", editor.say("scheme delete"), () => removeChosen(editor), true);
    this.put("whole", "M4 9V4H9M15 4H20V9M20 15V20H15M9 20H4V15", editor.say("whole"), () => editor.paper.fit(), true);
    this.element.append(editor.picture.button);
  }

  /**
   * @param {string} name
   * @param {string} icon
   * @param {string} title
   * @param {() => void} act
   * @param {boolean} [known] by its picture: no word stands beside it
   */
  put(name, icon, title, act, known = false) {
    const made = element("button", { type: "button", class: "tool", title, "aria-label": title, "data-tool": name });
    const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
    picture.setAttribute("viewBox", "0 0 24 24");
    picture.setAttribute("aria-hidden", "true");
    path.setAttribute("d", icon);
    picture.append(path);
    made.append(picture, ...(known ? [] : [element("span", {}, title)]));
    made.addEventListener("click", act);
    this.buttons.set(name, made);
    this.element.append(made);
  }

  show() {
    const { buttons, editor } = this;
    const { letter, number } = editor.chosen;
    for (const [tool] of TOOLS) buttons.get(tool)?.setAttribute("aria-pressed", String(editor.hand.tool === tool));
    buttons.get("undo")?.toggleAttribute("disabled", editor.history.past.length === 0);
    buttons.get("redo")?.toggleAttribute("disabled", editor.history.future.length === 0);
    buttons.get("delete")?.toggleAttribute("disabled", letter === undefined && number === undefined);
  }
}
