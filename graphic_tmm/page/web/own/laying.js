import { Flattening } from "./flatten.js";
import { refinedFrame } from "./frame.js";
import { pinholeOf } from "./lens.js";
import { Picture } from "./photo.js";
import { Shot } from "./shot.js";

/**
 * @typedef {import("./corners.js").Cornered} Cornered
 * @typedef {import("./corners.js").OwnPack} OwnPack
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {import("./shot.js").Photograph} Photograph
 * A photograph seen straight from above, of which what was clicked: its size in mm, how far its frame is off
 * @typedef {{picture: Picture, shot: Shot, of: Cornered, width: number, height: number, residual: number,
 *   bowed: number, missing: number[]}} LaidFlat
 */

/** The picture has no more dots, and none finer than the photograph's. */
const MOST_DOTS_FLAT = 6e6;
/** So long it is worked on before the page has its turn, ms. */
const SLICE = 50;

/**
 * Return the photograph laid flat; null if that was not wanted any more.
 * @param {Photograph} image
 * @param {Spot[]} corners
 * @param {Cornered} of
 * @param {OwnPack} pack
 * @param {(share: number) => void} told
 * @param {() => boolean} wanted
 * @returns {Promise<LaidFlat | null>}
 */
export async function layFlat(image, corners, of, pack, told, wanted) {
  told(0);
  await turnOfPage();
  const found = of.lines
    ? refinedFrame(image, of.box, corners, pack.seeking)
    : { shot: new Shot(of.box, corners, pinholeOf(image)), residual: NaN, bowed: 0, missing: [] };
  const [left, bottom, right, top] = of.area;
  const [width, height] = [right - left, top - bottom];
  const own = found.shot.dotsAt((left + right) / 2, (bottom + top) / 2);
  const dots = Math.min(own, Math.sqrt(MOST_DOTS_FLAT / (width * height)));
  const flat = new Flattening(image, found.shot, of.area, dots);
  while (!flat.done) {
    const until = performance.now() + SLICE;
    while (!flat.done && performance.now() < until) flat.step();
    told(flat.share);
    await turnOfPage();
    if (!wanted()) return null;
  }
  const picture = new Picture(await createImageBitmap(new ImageData(flat.data, flat.width, flat.height)));
  return { ...found, picture, of, width: flat.width / dots, height: flat.height / dots };
}

/** Let the page do what waits: paint, hear keys. */
function turnOfPage() {
  return new Promise((done) => window.setTimeout(done));
}
