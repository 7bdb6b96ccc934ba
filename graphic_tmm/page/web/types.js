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
 * @typedef {{language: string, title: string, words: Record<string, string>, parts: Record<string, string>, sheets: SheetSize[],
 *   views: View[]}} Data
 */
export {};
