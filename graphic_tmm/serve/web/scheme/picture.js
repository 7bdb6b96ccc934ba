import { drawnElement, element } from "../../../page/web/dom.js";
import { Flattening } from "../../../page/web/own/flatten.js";
import { pinholeOf } from "../../../page/web/own/lens.js";
import { canvasOf, contextOn, openedPhoto } from "../../../page/web/own/photo.js";
import { orderedCorners } from "../../../page/web/own/projection.js";
import { Shot } from "../../../page/web/own/shot.js";
import { apart } from "./sketch.js";

/**
 * The picture of a task's scheme, under what is drawn: deaf to the pointer, straightened by four corners.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./view.js").View} View
 * @typedef {import("./editor.js").Editor} Editor
 */

/** How much of the window it fills when it is laid down. */
const SHARE = 0.8;
const PALE = "0.45";
/** A picture with hills, as the other tools are drawn. */
const ICON = "M3 5H21V19H3ZM3 17L9 10L13 15L16 12L21 17";

export class Picture {
  /** @param {Editor} editor */
  constructor(editor) {
    this.editor = editor;
    /** @type {HTMLCanvasElement | null} */
    this.canvas = null;
    /** @type {import("../../../page/web/own/shot.js").Photograph | null} */
    this.image = null;
    /** Its upper left corner, m, and how many metres one of its dots is. @type {Place} */
    this.at = [0, 0];
    this.dot = 0.001;
    /** The corners that were clicked, dots of the picture; null while none are wanted. @type {Place[] | null} */
    this.corners = null;
    /** Whoever keeps it when it is another one. */
    this.kept = () => {};
    const { say } = { say: (/** @type {string} */ key) => editor.say(key) };
    this.input = /** @type {HTMLInputElement} */ (element("input", { type: "file", accept: "image/*", "aria-label": say("scheme picture"), class: "file" }));
    this.button = element("label", { class: "tool file-tool", title: say("scheme picture") }, drawnElement("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, drawnElement("path", { d: ICON })), element("span", {}, say("scheme picture")), this.input);
    this.straighten = element("button", { type: "button", class: "tool" }, say("scheme straighten"));
    this.away = element("button", { type: "button", class: "tool" }, say("scheme picture away"));
    this.pale = /** @type {HTMLInputElement} */ (element("input", { type: "range", min: "0.1", max: "1", step: "0.05", value: PALE, "aria-label": say("scheme pale") }));
    this.row = element("div", { class: "scheme-picture" }, this.pale, this.straighten, this.away);
    this.row.hidden = true;
    editor.paper.element.append(this.row);
    editor.paper.under = () => this.lay();
    this.input.addEventListener("change", () => void this.open(this.input.files?.[0]));
    this.pale.addEventListener("input", () => this.lay());
    this.away.addEventListener("click", () => this.put(null));
    this.straighten.addEventListener("click", () => {
      this.corners = [];
      editor.tell(editor.say("scheme corner", { n: 1 }));
    });
    const window_ = editor.paper.element;
    window_.addEventListener("dragover", (event) => event.preventDefault());
    window_.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.open(event.dataTransfer?.files[0]);
    });
  }

  /** @param {File | undefined} file */
  async open(file) {
    if (file === undefined) return;
    const { editor } = this;
    const opened = await openedPhoto(file);
    this.input.value = "";
    if (typeof opened === "string") {
      editor.tell(editor.say(opened === "own pdf" ? "scheme pdf" : "photo unread", { name: file.name }));
      return;
    }
    const { image } = opened;
    const { view } = editor.paper;
    const share = SHARE * Math.min(view.width / image.width, view.height / image.height);
    this.dot = share / view.scale;
    this.at = view.place([(view.width - share * image.width) / 2, (view.height - share * image.height) / 2]);
    this.put(image);
  }

  /** @param {import("../../../page/web/own/shot.js").Photograph | null} image */
  put(image) {
    this.show(image);
    this.kept();
  }

  /** @param {import("../../../page/web/own/shot.js").Photograph | null} image */
  show(image) {
    this.canvas?.remove();
    this.image = image;
    this.corners = null;
    this.row.hidden = image === null;
    this.canvas = image === null ? null : canvasOf(image.width, image.height);
    if (this.canvas === null || image === null) return;
    contextOn(this.canvas).putImageData(new ImageData(new Uint8ClampedArray(image.data), image.width, image.height), 0, 0);
    this.canvas.setAttribute("aria-hidden", "true");
    this.editor.paper.element.prepend(this.canvas);
    this.lay();
  }

  /** Lay it where it belongs under the paper. */
  lay() {
    if (this.canvas === null) return;
    const { view } = this.editor.paper;
    const [x, y] = view.dots(this.at);
    this.canvas.style.transform = `translate(${x}px, ${y}px) scale(${this.dot * view.scale})`;
    this.canvas.style.opacity = this.pale.value;
  }

  /** @param {Place} by m */
  shift([x, y]) {
    this.at = [this.at[0] + x, this.at[1] + y];
  }

  /** @param {number} by */
  scale(by) {
    this.at = [this.at[0] * by, this.at[1] * by];
    this.dot *= by;
  }

  /**
   * Take a corner if one is wanted; at the fourth the picture is straightened.
   * @param {Place} place
   * @returns {boolean} whether it was wanted
   */
  corner(place) {
    const { corners, image, editor } = this;
    if (corners === null || image === null) return false;
    corners.push([(place[0] - this.at[0]) / this.dot, (this.at[1] - place[1]) / this.dot]);
    if (corners.length < 4) {
      editor.tell(editor.say("scheme corner", { n: corners.length + 1 }));
      return true;
    }
    const ring = orderedCorners(corners);
    this.corners = null;
    if (ring === null) editor.tell(editor.say("scheme corners wrong"));
    else this.flatten(image, /** @type {[Place, Place, Place, Place]} */ (ring));
    return true;
  }

  /**
   * Show what four corners are of as a rectangle whose sides are as long as theirs in the mean.
   * @param {import("../../../page/web/own/shot.js").Photograph} image
   * @param {[Place, Place, Place, Place]} ring
   */
  flatten(image, ring) {
    const [a, b, c, d] = ring;
    const width = (apart(a, b) + apart(d, c)) / 2;
    const height = (apart(a, d) + apart(b, c)) / 2;
    const shot = new Shot([0, 0, width, height], ring, pinholeOf(image));
    const flat = new Flattening(image, shot, [0, 0, width, height], 1);
    while (!flat.done) flat.step();
    this.put({ width: flat.width, height: flat.height, data: flat.data });
  }
}
