/**
 * What Python packs for the page; the names are those of page/views.py, page/sentences.py, page/values.py, page/tools.py.
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
 *   box: number[], names: Record<string, string>, position: string, first: number, main: boolean, pictures: Picture[],
 *   values: Record<string, Row[]>, mechanism?: number, joints?: Joint[], joined?: Record<string, number[]>}} View
 * @typedef {[number, string, boolean, ...number[]]} Joint a point of a mechanism; page/views.py
 * @typedef {{name: string, width: number, height: number, format: string}} SheetSize
 * @typedef {{language: string, title: string, words: Record<string, string>, sheets: SheetSize[],
 *   parts: Record<string, string>, views: View[], crank?: Dense, live?: LiveData, practice?: Practice,
 *   own?: import("./own/corners.js").OwnPack, accuracy?: ErrorShares[],
 *   turning?: Turning}} Data
 * @typedef {{quantity: string, shares: [string, number, string][], student?: boolean, most?: string,
 *   stop?: [number, number], views: number[]}} ErrorShares sources of an error with their shares in %, the largest
 *   first; the step that brings most, view and picture of it; the views that it belongs to; page/error_shares.py
 *
 * Cams and wheels that turn; the names are those of page/turning.py. A move turns counter-clockwise about a place or
 * shifts along a direction, both with y downward; a body drawn once may have copies about a place: how many, where.
 * @typedef {[boolean, number, number, import("./turning/courses.js").Course]} Move
 * @typedef {{strokes: [string, string, boolean][], moves: Move[], copies?: [number, number, number],
 *   letters?: [number, number, number, number, number][]}} RigidBody a letter: its glyph, where its base line begins
 *   (y upward), the place that is carried
 * @typedef {{title: string, caption: string, box: number[], still: [string, string, boolean][],
 *   stands: [number, number, number][], bodies: RigidBody[],
 *   values: [string, string, number, import("./turning/courses.js").Course][]}} TurningFigure
 * @typedef {{decimal: string, pens: Dense["pens"], figures: TurningFigure[], glyphs: Glyph[]}} Turning
 *
 * The mechanism at every degree; the names are those of page/crank.py. A coordinate is a number of thousandths of
 * a millimetre, or a row and a distance; what is not always there says from which to behind which angle it is.
 * @typedef {0 | number[]} There
 * @typedef {[string, [number, string][]]} Glyph words, strokes by pen
 * @typedef {{letter: string, unit: string, places: number, texts: (string | null)[], row: number[],
 *   worth: number, there: There, log?: number[]}} Value `log`: its mark, that of its scale (-1: none), 1 if its size counts
 * @typedef {{name: string, title: string, caption: string, box: number[], refined: number[], rows: number[],
 *   lines: [string, number, number[][], 0 | number[][], There, Variant[]?][],
 *   letters: [number, number[], number[], There, Variant[]?][], values: Value[], still?: [string, string][],
 *   stands?: [number, number, number][], crank?: number[]}} MovingFigure
 * @typedef {{view: string, letter: string, unit: string, mu: number, origin: number, upright: boolean,
 *   x: number[], y: number[], there: There, texts: (string | null)[], curve?: number, of?: number, at?: [number, number],
 *   behind?: number, base?: number[], point?: number}} Cursor `curve`, `of`: the curve and its scale factor, by slots;
 *   `at`: where its view begins on the sheet; `behind`: so many positions behind others; `base`: its ends, none of a curve
 *   whose knots are the positions; `point`: of a curve over points that move the mark that runs on it
 * @typedef {{view: string, letter: string, unit: string, text: string, slot: number}} Result what comes out of a view
 * `ends`: of a row that is no whole turn, what its place is called, where it begins, how far a step goes.
 * @typedef {{whole: number, step: number, sense: number, zero: number, more: number[], lengths: number[],
 *   ends?: {letter: string, unit: string, from: number, per: number},
 *   positions: [string, number][], begins: number, why: [number, number, string][], decimal: string,
 *   pens: Record<string, [number, number[], string, string]>, figures: MovingFigure[], cursors: Cursor[],
 *   glyphs: Glyph[], ties?: Ties, numbers?: [number, number, number], results?: Result[],
 *   hangs?: Record<string, number[]>, segments?: [string, ...number[]][]}} Dense `numbers`: of the row, the first, by how
 *   much they go on, how many there are; `hangs`: on which marks ink of others hangs;
 *   `segments`: lines of ink from mark to mark: view, slot, width of the pen, both marks, where their plan
 *   begins on the sheet, how far it goes on beyond both marks
 *
 * Ink tied to marks; the names are those of page/tied_pack.py. What is tied has no coordinates where its variants tell
 * all of it; of a letter they are how far it is off its point.
 * @typedef {[number, number[], 0 | number[]]} Variant under which comparisons (index in `holds`), places, bulges: nodes
 * @typedef {{ops: string, of: number[], numbers: number[], holds: number[][]}} Ties expressions: the sign of each, of
 *   which it is made (how far before it), numbers; comparisons: a node from 1 on, below 0 where it is false
 *
 * Live lengths; the names are those of page/live. A mark is known by its slot. A given is told by its kind and its
 * numbers: one after the other at each angle, or as a straight row: its first number, and by how much it goes on.
 * @typedef {{k: Kind, v?: (number | null)[], row?: [number, number]}} Told
 * @typedef {{in: string, name: string, unit: string, by: number, pair?: [number, number], part?: number, rest?: string,
 *   less?: [string, string, number]}} SceneKey a number of the scene; the letter is `by` times it, less another first
 * @typedef {{l: string, n: string, u: string, by: number, v: number, slots: number[], minus?: number[], plan?: string,
 *   key?: SceneKey}} Slider what can be changed, in SI; told in `u`, `by` times; `minus`: what is its opposite
 * @typedef {[number, ["on" | "aside" | "from", number, number, number][], number?]} JointLimbs a joint, and how it is measured: along
 *   a line or aside from it, or from a centre; from which mark, the given length, its scale; of the crank's pin its pivot
 * @typedef {{size: number, more: number[], given: Record<string, Told>, kept: Record<string, Told>,
 *   positions: number, rowed: Record<string, Told>, carried: number[], sliders: Slider[],
 *   breaks: [number, string][], pin: number[], paths: number[], joints: JointLimbs[], scales: ScalesData, out?: Output}} LiveData
 * @typedef {{slot: number, scale: number, turn: number, l: string, pivot?: number}} Output what the mechanism moves to and
 *   fro: a point by its letter, or a link by its number and a point of it; so many steps are a turn
 * @typedef {{mu: number, rule: string, of: number[], at?: number[], n: number[], by?: number[]}} FreeScale a scale factor that
 *   the page may choose: by which rule, of which points, in which places (index; else the positions of the sheet),
 *   numbers of the rule, marks that it hangs on; page/live/scales.py
 * @typedef {{lengths: number[], mantissas: number[], ratios: number[], free: FreeScale[], shown: Record<string, number>}}
 *   ScalesData standard rows; free scale factors; the scale factor (slot) of a view
 *
 * Practice; the names are those of page/practice/pack.py. Points are mm from the origin of their plan (its pole), y
 * upward. A mark is named by its slot in the log, a position by its index in `names`.
 * @typedef {{re: number, im: number}} Complex
 * @typedef {{at: Complex, along: Complex}} DrawnLine
 * @typedef {{centre: Complex, radius: number}} DrawnArc
 * @typedef {{knots: Complex[][], tangents: Complex[][], closed: boolean}} DrawnCurve arrays of one trial
 * @typedef {Drawn | DrawnCurve | undefined} AcrossMark what a mark is in a position of the sheet
 * @typedef {number | Complex | DrawnLine | DrawnArc} Drawn what a mark is: a length, an angle, a quantity, a point …
 * @typedef {"point" | "line" | "arc" | "length" | "angle" | "number" | "side"} Kind
 * @typedef {{l: string, n: string, k: Kind, v: number, u?: string, s?: 1}} PracticeMark its letter as mark-up, as
 *   plain text, its kind, its plan (index in `plans`), its unit, whether it is the scale factor of a plan
 * @typedef {["line" | "arc" | "met" | "laid" | "place", number, number]} Part what a point may be off: of which
 *   kind, the mark of the step that is blamed, the number of the mark among what the point's step uses
 * @typedef {["ray" | "arc" | "line", number, ...number[]]} Limb one of two conditions that fix a point in another way than its
 *   step's: of which kind, about which mark, by a length measured between which two; of a line the point or the line it
 *   goes through (checking/judging/equivalents.py)
 * @typedef {{it: number, op: string, uses: number[], choice?: number[], choices?: string[], measures?: boolean,
 *   parts?: Part[], ways?: [Limb, Limb][], read?: Reading, text?: Run[], why?: Run[], formula?: string, tool?: string, hand?: string, sides?: [string, string]}} PracticeStep
 *   `choice`: by `choices`, their names; `measures`: it reads what is drawn; `read`: what `check` reads of it, by which name; without it nothing does. `text`, `why`: its sentence and reason;
 *   `formula`: with letters alone; `tool`: the instruments in words, `hand`: their letters in geometrography;
 *   `sides`: what +1 and −1 of its side, or of its choice, are called. Only steps of practice have these
 * @typedef {{as: "point" | "length" | "rate", name: string, key: string, unit: string}} Reading a row of a check: what
 *   it gives, plan, segment, the unit of a rate
 * @typedef {{plan: number, at: number, view: number, sheet: number, origin: [number, number], steps: number[], free?: number[],
 *   shown: number[], pole: number, whole: number, goal: string, pose?: boolean}} Task a plan in a position: `goal` in words, `view` of the page that
 *   shows it (-1: none), its sheet, where its origin lies on that (mm, y downward), the marks that are to be made, in the order of
 *   the log, `free`: lines that may be drawn besides, those of other plans that they need, its pole (-1: none), its longest vector in mm; a `pose` is at an angle
 *   of the crank that no sheet has
 * @typedef {{b: number[][], d: number[], w: number[], s?: number[][], m?: number[]}} OwnLimit by position (its index
 *   in `at`): the sizes of the errors that a hand makes, part by part; from where on in these an error is doubtful,
 *   wrong; of a point the sizes if it were read without a slip, and below what most errors are; -1, []: nothing
 * @typedef {{d: number[], w: number[], t: number[]}} TotalLimit by position: from where on a deviation is doubtful,
 *   wrong, and how many times too large is absurd (a logarithm; -1: nothing)
 * @typedef {{pointing: number, own: Record<string, OwnLimit>, with: Record<string, Record<string, OwnLimit>>,
 *   total: Record<string, TotalLimit>, placed: Record<string, number[]>}} Manner how a drawing is read, and the limits of the hand then; `with`: where
 *   points of other plans before that one are read too, by the numbers of these; `placed`: by position, within which a point that other lines lead to is where it is due
 * @typedef {{half: number, reading: number, swing: number, compass: number, prick: number, digits: number,
 *   wrong: number, pair: {doubtful: number, wrong: number}, sine: number,
 *   shares: number[], few: number, most: number, sure: number}} Reader who reads: half a division of the ruler, the
 *   slips of reading (mm), of a ray (°), of an opening and a point (mm), the digits of a calculation; and how it is judged (checking/judging)
 * @typedef {{hand: string, names: string[], main: number, plans: string[], titles: string[], marks: Record<string, PracticeMark>,
 *   given: Record<string, number | number[] | (number | null)[]>, steps: PracticeStep[], tasks: Task[], at: number[][],
 *   reader: Reader, manners: Record<string, Manner>}} Practice
 *   `given`: a number, one a position, of a point x, y in turn. `at`: by plan the positions that it is drawn in, to
 *   which limits belong. `manners`: "plan": all of a plan is read, its points on a screen; "points": only its
 *   points are, off a photograph
 */
export {};
