import { boxAbout, boxesMeet } from "./sheet-bounds.js";

/**
 * @typedef {import("./sheet-bounds.js").Box} Box
 * @typedef {import("./sheet-ink.js").Ink} Ink
 * @typedef {import("./sheet-ink.js").Pen} Pen
 */

/**
 * Paths of one pen that follow each other, as one; letters are as fine as they are small.
 * @typedef {{path: Path2D, box: Box, pen: Pen, count: number, letters: boolean}} Batch
 */

/** As many paths are drawn at once: few calls, and little is drawn that is out of sight. */
const BATCH = 24;
/** No line is thinner than this, and heavier ones stay heavier: px, px a millimetre. */
const LEAST = 0.3;
const LEAST_OF_PEN = 0.7;

/**
 * Return ink in its order as batches; letters may be drawn larger.
 * @param {Iterable<Ink>} ink
 * @param {Map<number, DOMMatrix>} grown how labels are enlarged, by their numbers
 * @returns {Batch[]}
 */
export function batchesOf(ink, grown) {
  /** @type {Batch[]} */
  const batches = [];
  let view = -1;
  for (const one of ink) {
    const larger = one.label < 0 ? undefined : grown.get(one.label);
    const pen = larger === undefined ? one.pen : grownPen(one.pen, larger.a);
    let batch = batches.at(-1);
    const full = batch === undefined || batch.pen.key !== pen.key || batch.count === BATCH || view !== one.view;
    if (batch === undefined || full || pen.fill !== "" || batch.letters !== one.label >= 0) {
      batch = { path: new Path2D(), box: one.box, pen, count: 0, letters: one.label >= 0 };
      batches.push(batch);
    }
    batch.path.addPath(one.path, larger);
    batch.box = boxAbout([batch.box, larger === undefined ? one.box : movedBox(one.box, larger)]);
    batch.count += 1;
    view = one.view;
  }
  return batches;
}

/**
 * @param {Pen} pen
 * @param {number} factor
 * @returns {Pen}
 */
function grownPen(pen, factor) {
  return { ...pen, width: factor * pen.width, key: `${pen.key}|${factor}` };
}

/**
 * @param {Box} box
 * @param {DOMMatrix} by
 * @returns {Box}
 */
function movedBox(box, by) {
  return [by.a * box[0] + by.e, by.d * box[1] + by.f, by.a * box[2] + by.e, by.d * box[3] + by.f];
}

/**
 * Draw batches that are seen; the context is set to millimetres already.
 * @param {CanvasRenderingContext2D} context
 * @param {Batch[]} batches
 * @param {Box} seen mm
 * @param {number} zoom CSS px a millimetre, to be read on a screen; 0: on paper
 */
export function paintBatches(context, batches, seen, zoom) {
  let key = "";
  for (const { path, box, pen, letters } of batches) {
    if (!boxesMeet(box, seen)) continue;
    if (pen.key !== key) {
      takePen(context, pen);
      key = pen.key;
    }
    context.lineWidth = letters || zoom === 0 ? pen.width : widthOn(pen.width, zoom);
    if (pen.fill !== "") context.fill(path);
    if (pen.stroke !== "" && pen.width > 0) context.stroke(path);
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Pen} pen
 */
function takePen(context, pen) {
  context.strokeStyle = pen.stroke;
  context.fillStyle = pen.fill;
  context.lineCap = /** @type {CanvasLineCap} */ (pen.cap);
  context.lineJoin = /** @type {CanvasLineJoin} */ (pen.join);
  context.setLineDash(pen.dashes);
}

/**
 * Return how wide a line is drawn, mm: as on paper, but never so thin that the screen makes it pale.
 * @param {number} width
 * @param {number} zoom
 */
function widthOn(width, zoom) {
  return Math.max(width, (LEAST + LEAST_OF_PEN * width) / zoom);
}

/**
 * Draw ink once more, lit: wider than it is and in another colour.
 * @param {CanvasRenderingContext2D} context
 * @param {Ink[]} ink
 * @param {string} colour
 * @param {number} zoom
 */
export function paintLit(context, ink, colour, zoom) {
  for (const one of ink) {
    takePen(context, one.pen);
    context.lineWidth = widthOn(one.pen.width, zoom) + 1.5 / zoom;
    context.strokeStyle = colour;
    context.fillStyle = colour;
    if (one.pen.stroke === "" && one.pen.fill !== "" && one.pen.fill !== "white") context.fill(one.path);
    else if (one.pen.stroke !== "") context.stroke(one.path);
  }
}
