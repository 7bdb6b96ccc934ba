/**
 * What Python packs for the page; the names are those of page/views.py, page/told.py, page/values.py, page/tools.py.
 *
 * @typedef {string | [string, number]} Run text, or the mark-up of a letter with the slot of its mark
 * @typedef {{s: string, u: number, of: number[], from: number, to: number}} Term a vector: its letter, how many
 *   lines are under it, the marks that draw it, the stops in which its line is drawn and it is whole
 * @typedef {{sides: Term[][], ways: string}} Equation
 * @typedef {[number[], string, string, string, string, string]} Row slots, segment, mm, μ, value, quantity
 * @typedef {[string, string, ...number[]]} Tool its kind, what it is called, where it lies (sheet mm, y downward)
 * @typedef {{head?: boolean, text?: Run[], why?: Run[], calc?: string, row?: Row, read?: string, sign?: string, it?: number,
 *   uses?: number[], op?: string, equation?: Equation, tool?: Tool}} Line a sentence of the protocol; with a head what
 *   stands above the steps that follow; without a mark (it) a remark
 * @typedef {{keys: string[], marks?: number[], at: number, again?: boolean, lines: Line[]}} Picture a stop: a step,
 *   with the ink that it leaves (none: no keys), or what is drawn again in another position
 * @typedef {{id: string, plan: string, family: string, title: string, board: string, sheet: number,
 *   box: number[], names: Record<string, string>, position: string, first: number, pictures: Picture[],
 *   values: Record<string, Row[]>, mechanism?: number, joints?: Joint[], joined?: Record<string, number[]>}} View
 * @typedef {[number, string, boolean, ...number[]]} Joint a point of a mechanism; page/inset.py
 * @typedef {{name: string, width: number, height: number, format: string}} SheetSize
 * @typedef {{language: string, title: string, words: Record<string, string>, sheets: SheetSize[],
 *   parts: Record<string, string>, views: View[], crank?: Dense}} Data
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
