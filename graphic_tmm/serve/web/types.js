/**
 * What the server tells; the names are those of serve/kept.py, serve/form.py and serve/shell.py.
 *
 * @typedef {Record<string, string>} Words
 * @typedef {{lines: number[][], values: Record<string, string>}} Picture a way out: lines as x, y by turns; what is written then
 * @typedef {{line: number, key: string, text: string, source?: string, place?: string, pictures?: Picture[]}} Fault a fault of the
 *   file, with its line; place: its key in words
 * @typedef {{name: string, hash: string, width: number, height: number}} Sheet its size in mm
 * @typedef {{version: number, text_version: string, ok: boolean, busy: boolean, fresh: boolean, errors: Fault[],
 *   failed: string, warnings: string[], sheets: Sheet[], page: string | null, name?: string}} State fresh: the sheets are the text's; failed: why
 *   it was not drawn to its end though nothing may be wrong in it
 * @typedef {{key: string, label: string, place: string, text: string, written: boolean, kind: string, unit: string,
 *   choices: string[], default: string, says: string, wanted: boolean}} Field
 * @typedef {{title: string, says: string, there: boolean, fields: Field[]}} Group
 * @typedef {{version: string, groups: Group[]}} Form
 * @typedef {{form: string, name: string}} Download
 * @typedef {{language: string, words: Words, name: string, several: boolean, fixed: boolean, photographed: boolean,
 *   downloads: Download[]}} Studio
 * @typedef {{language: string, words: Words, fixed: boolean, scenes: {name: string, title: string}[]}} Gallery
 * @typedef {[number, number]} Spot dots of a photograph from the centre of its first, downward
 * @typedef {{plan: string, name: string, pole: string, first: string, positions: string[]}} Plan
 * @typedef {Plan & {position: string}} Place a plan in a position
 * @typedef {{plans: Plan[], sheets: string[], papers: string[], errors: string[]}} Clickable
 * @typedef {{what: "pole" | "first" | "corner", plan: string, position: string}} Target
 * @typedef {Target & {spot: Spot}} Click
 * @typedef {{plan: string, position: string, pole: Spot, first: Spot | null}} Proposal a plan that seems to be there
 * @typedef {{spot: Spot, text: string, kind: string}} Mark
 * @typedef {{page: string, says: string, warnings: string[], stale?: boolean,
 *   marks: {x: number, y: number, text: string, verdict: string}[]}} Checked page: the hash of its report
 * @typedef {import("./scheme/sketch.js").Sketch} Sketch
 * @typedef {{key: string, kind: string, label: string, text: string, link: number | null, name: string,
 *   choices: string[], placeholder: string, unit: string, says: string}} SchemeField link: whose it is; name: of a length used elsewhere, too;
 *   unit: that a bare number has where the text has none
 * @typedef {{name: string, says: string, form: "" | "row" | "table" | "ticked", choices: [string, string][], example: string, unit: string,
 *   wanted: boolean}} SectionKey choices: with what they are called
 * @typedef {{name: string, says: string, keys: SectionKey[], there: string[]}} OfferedSection there: those of it that the scene has
 * @typedef {{letter: string, unit: string, low: number, high: number, closed: boolean}} Sweep what a drive goes through
 * @typedef {{letter: string, at: [number, number], way: [number, number], turns: number, end: [number, number] | null, pushes: boolean}} LoadSign
 *   what acts; way: of a force, of length 1, which pushes if it ends there; turns: of a moment; end: of a spring
 * @typedef {{at: number[], places: Record<string, ([number, number] | null)[]>, loads: LoadSign[][]}} Turn
 * @typedef {{version: string, sketch: Sketch, mobility: number | null, formula: string, says: string, text: string | null,
 *   at: number | null, sweep: Sweep | null, loads: LoadSign[], fields: SchemeField[], sections: OfferedSection[], errors: string[], turn: Turn | null, shift: [number, number]}} SchemeAnswer
 *   text: the scene, null while something is missing; says: what; shift: of the origin, m
 * @typedef {{text: string, sketch?: Sketch | null, letters?: Record<string, string>, numbers?: Record<string, number>,
 *   typed?: Record<string, string>, scale?: boolean, at?: number | null, turn?: number, section?: string, own?: string,
 *   version?: string, back?: boolean}} SchemeAct back: to the text that was
 * @typedef {{answer: SchemeAnswer | null, errors: string[], status: number, newer?: SchemeAnswer}} SchemeTold status 409: the file
 *   has changed; newer: what it was then, before the act was done on that, if it was
 * @typedef {{language: string, words: Words, several: boolean}} DrawingPaper
 * @typedef {{status: number, version: string, errors: Fault[]}} Answer status 0: nothing came back
 */
export {};
