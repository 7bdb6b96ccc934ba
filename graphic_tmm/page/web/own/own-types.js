/**
 * What Python packs for a drawing of one's own; the names are those of page/practice/own.py.
 * @typedef {import("./projection.js").Rectangle} Rectangle
 * @typedef {{frames: Rectangle[], papers: [string, number, number][], heads: string[], separator: string,
 *   decimal: string, begins: string, seeking: import("./strip.js").Seeking, bent: number, bowed: number}} OwnPack
 *   `frames`: of each sheet, mm from its lower left corner; `papers`: formats, mm; how readings are written down;
 *   how a frame is sought; from where on a bent sheet, a bowing lens is told of, mm
 * What four corners are clicked of: a rectangle of the sheet, what of it is looked at, the number of the sheet whose
 * frame it is (-1: of none); whether its lines are sought
 * @typedef {{box: Rectangle, area: Rectangle, sheet: number, lines: boolean}} Cornered
 */
export {};
