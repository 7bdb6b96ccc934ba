/**
 * What Python packs for the page; the names are those of page/views.py and page/told.py.
 *
 * @typedef {string | [string, number]} Run text, or the mark-up of a letter with the slot of its mark
 * @typedef {{symbol: string, known?: boolean, way?: string, marks?: number[], line?: number}} Term
 * @typedef {{sought: Term, marks: number[], sides: Term[][]}} Equation
 * @typedef {{n?: string, text: Run[], why?: Run[], calc?: string, it?: number, uses?: number[], op?: string,
 *   equation?: Equation}} Line a sentence of the protocol; without n a remark
 * @typedef {{keys: string[], marks: number[], at: number, again?: boolean}} Picture
 * @typedef {{id: string, plan: string, family: string, title: string, board: string, sheet: number,
 *   box: number[], names: Record<string, string>, position: string, first: number,
 *   lines: Record<string, Line[]>, pictures: Picture[]}} View
 * @typedef {{name: string, width: number, height: number, format: string}} SheetSize
 * @typedef {{language: string, title: string, words: Record<string, string>, sheets: SheetSize[],
 *   views: View[], crank?: Dense}} Data
 *
 * The mechanism at every degree; the names are those of page/crank.py. A coordinate is a number of thousandths of
 * a millimetre, or a row and a distance; what is not always there says from which to behind which angle it is.
 * @typedef {0 | number[]} There
 * @typedef {[string, [number, string][]]} Glyph words, strokes by pen
 * @typedef {{letter: string, unit: string, places: number, texts: (string | null)[], row: number[],
 *   worth: number, there: There}} Value
 * @typedef {{name: string, title: string, caption: string, box: number[], refined: number[], rows: number[],
 *   lines: [string, number, number[][], 0 | number[][], There][],
 *   letters: [number, number[], number[], There][], values: Value[], still?: [string, string][],
 *   stands?: [number, number, number][], crank?: number[]}} MovingFigure
 * @typedef {{view: string, letter: string, unit: string, mu: number, origin: number, upright: boolean,
 *   x: number[], y: number[], there: There, texts: (string | null)[]}} Cursor
 * @typedef {{whole: number, step: number, sense: number, zero: number, more: number[], lengths: number[],
 *   positions: [string, number][], why: [number, number, string][], decimal: string,
 *   pens: Record<string, [number, number[], string, string]>, figures: MovingFigure[], cursors: Cursor[],
 *   glyphs: Glyph[]}} Dense
 */
export {};
