import { element } from "../dom.js";

/** @typedef {import("./shot.js").Photograph} Photograph */

/** What files begin with: a place, signs there, what they are. @type {[number, string, string][]} */
const BEGINNINGS = [
  [0, "\xff\xd8\xff", "jpeg"],
  [0, "\x89PNG\r\n", "png"],
  [8, "WEBP", "webp"],
  [0, "GIF8", "gif"],
  [0, "BM", "bmp"],
  [0, "%PDF", "pdf"],
  [0, "II*\0", "tiff"],
  [0, "MM\0*", "tiff"],
  [4, "ftypavif", "avif"],
  [4, "ftyp", "heic"],
];
/** What no browser reads; the page tells by name what is to be done. */
const NOT_READ = ["pdf", "tiff", "heic"];
/** Bytes that are looked at; the most that a file may have. */
const LOOKED_AT = 32;
const MOST_BYTES = 200e6;
/** A larger photograph is made smaller: some telephones hold no more on a canvas. */
const MOST_DOTS = 16.5e6;
/** Of what is seen small there is a copy, so many times smaller. */
const COPY = 4;
const WHITE = "#fff";

/** A picture, and a smaller copy of it. */
export class Picture {
  /** @param {ImageBitmap} source */
  constructor(source) {
    this.source = source;
    this.width = source.width;
    this.height = source.height;
    this.small = canvasOf(source.width / COPY, source.height / COPY);
    const context = contextOn(this.small);
    context.fillStyle = WHITE;
    context.fillRect(0, 0, this.small.width, this.small.height);
    context.imageSmoothingQuality = "high";
    context.drawImage(source, 0, 0, this.small.width, this.small.height);
  }

  /**
   * Draw it into a rectangle; from its copy where that is fine enough.
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   * @param {number} height
   * @param {number} dots of the screen to one of its own
   */
  paint(context, width, height, dots) {
    context.drawImage(dots * COPY < 1.5 ? this.small : this.source, 0, 0, width, height);
  }
}

/**
 * Return what a file is by its first bytes; "" for what is not known.
 * @param {Uint8Array} bytes
 */
export function formatOf(bytes) {
  const text = String.fromCharCode(...bytes.slice(0, LOOKED_AT));
  return BEGINNINGS.find(([at, signs]) => text.startsWith(signs, at))?.[2] ?? "";
}

/**
 * Read a photograph, upright as its camera says; a text is the name of the words that tell why it cannot be.
 * @param {Blob} file
 * @returns {Promise<{picture: Picture, image: Photograph} | string>}
 */
export async function openedPhoto(file) {
  const format = formatOf(new Uint8Array(await file.slice(0, LOOKED_AT).arrayBuffer()));
  if (NOT_READ.includes(format)) return `own ${format}`;
  if (format === "") return "own unknown";
  if (file.size > MOST_BYTES) return "own large";
  try {
    const whole = await createImageBitmap(file, { imageOrientation: "from-image" });
    const part = Math.min(1, Math.sqrt(MOST_DOTS / (whole.width * whole.height)));
    const canvas = canvasOf(whole.width * part, whole.height * part);
    const context = contextOn(canvas, true);
    context.fillStyle = WHITE;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingQuality = "high";
    context.drawImage(whole, 0, 0, canvas.width, canvas.height);
    const image = context.getImageData(0, 0, canvas.width, canvas.height);
    const source = part < 1 ? await createImageBitmap(canvas) : whole;
    return { picture: new Picture(source), image };
  } catch {
    return "own damaged";
  }
}

/**
 * Return a canvas of a size.
 * @param {number} width
 * @param {number} height
 */
export function canvasOf(width, height) {
  const size = { width: String(Math.max(Math.round(width), 1)), height: String(Math.max(Math.round(height), 1)) };
  return /** @type {HTMLCanvasElement} */ (element("canvas", size));
}

/**
 * Return the context of a canvas.
 * @param {HTMLCanvasElement} canvas
 * @param {boolean} read whether its dots are read
 */
export function contextOn(canvas, read = false) {
  const found = canvas.getContext("2d", { willReadFrequently: read });
  return /** @type {CanvasRenderingContext2D} */ (found);
}
