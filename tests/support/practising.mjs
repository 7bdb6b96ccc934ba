// Every task of many scenes, worked by node as a student works it: an instrument, what it is laid to, what comes of it.
import { readFileSync, writeFileSync } from "node:fs";

const [, , asked, answered] = process.argv;
const { Session } = await import("./practice/session.js");
const { instrumentOf } = await import("./practice/palette.js");
const { done } = await import("./practice/log.js");
const { hasSides, tellSide } = await import("./practice/sides.js");
const { csvOf } = await import("./practice/record.js");
const answers = [];
for (const { written, data, words, drawn } of JSON.parse(readFileSync(asked, "utf8"))) {
  await import(`./practice/${written}`);
  const page = { title: written, practice: data, words, views: [] };
  const tasks = drawn ? [] : data.tasks;
  const worked_ = tasks.map((_, n) => ({ first: worked(page, n, 0), last: worked(page, n, -1), wrong: wronged(page, n) }));
  answers.push(drawn ? drawn.map(([n, seed]) => clumsy(page, n, seed)) : worked_);
}
writeFileSync(answered, JSON.stringify(answers));

/** Work a task by its own due answers, the first or the last step of what is open first. */
function worked(page, n, which) {
  const session = new Session(page, n);
  session.clear();
  const order = [];
  const faults = [];
  for (let step = open(session, which); step !== undefined; step = open(session, which)) {
    const { kind, slot } = laid(session, step);
    if (step.formula === undefined && instrumentOf(step.op).name === "formula") faults.push([step.it, "without an instrument"]);
    if (kind === "asked") answer(session, slot);
    if (kind !== "asked" && kind !== "drawn") faults.push([step.it, kind, slot]);
    if (faults.length > 3) break;
    order.push(slot);
  }
  const poor = session.task.tries.filter((one) => one.verdict !== "fine").map((one) => [one.slot, one.verdict, one.error]);
  const record = session.record();
  return { order, faults: [...faults, ...poor], ready: session.task.ready, score: record.score, readings: session.readings() };
}

/** The steps that can be done and are not; of them the first (0) or the last (-1). */
function open({ task, bench }, which) {
  return task.moves.filter((move) => !task.isDone(move.it) && bench.ready(move.it)).at(which);
}

/** Take the instrument of a step, lay it to what the step asks for, the last first. */
function laid({ task }, move) {
  task.choose(instrumentOf(move.op).name);
  let outcome = { kind: "more" };
  for (const slot of [...task.picking.asked(move)].reverse()) outcome = task.pick(slot);
  return outcome.kind === "more" ? task.submit() : outcome;
}

/** Answer a step that is asked: the side on which a line is drawn, or what it came to. */
function answer(session, slot) {
  const { task, bench } = session;
  const move = task.own.get(slot);
  if (!hasSides(task, move)) return told(session, slot, bench.due(slot));
  return tellSide(task, bench.value(move.uses.find((one) => task.kindOf(one) === "side")));
}

/** Tell what came of a step, as the page does: places to a hundredth, figures to five digits. */
function told({ task, easel }, slot, value) {
  if (typeof value !== "number") {
    const [x, y] = [value.re, value.im].map((one) => one.toFixed(2));
    return task.tell({ re: Number(x), im: Number(y) }, [x, y], { x: 0.005, y: 0.005 });
  }
  const length = easel.kindOf(slot) === "length";
  const text = length ? value.toFixed(2) : value.toPrecision(6);
  const half = 0.5 * 10 ** -(text.split(".")[1]?.length ?? 0);
  return task.tell(Number(text), [text], length ? { mm: half } : { value: half });
}

/** Do each step of a task wrong in every way, then right; return how each was judged. */
function wronged(page, n) {
  const session = new Session(page, n);
  session.clear();
  const found = [];
  for (let step = open(session, 0); step !== undefined; step = open(session, 0)) {
    found.push(...otherInstruments(session, step));
    const { kind, slot } = laid(session, step);
    if (kind === "none" || kind === "more" || kind === "undrawable") break;
    if (kind === "asked") {
      found.push(...otherAnswers(session, slot));
      answer(session, slot);
    }
  }
  return found;
}

/** Lay all other instruments to what a step asks for. */
function otherInstruments({ task, bench }, move) {
  const found = [];
  for (const name of ["edge", "parallel", "square", "compass", "laying", "meeting", "figure", "reading"]) {
    const picks = task.picking.asked(move);
    if (name === instrumentOf(move.op).name) continue;
    task.choose(name);
    let outcome = { kind: "more" };
    for (const slot of picks) outcome = task.fits(slot) ? task.pick(slot) : { kind: "none", answer: { why: "it fits nowhere" } };
    if (outcome.kind === "more") outcome = task.submit();
    // what is done of it is a step of its own: another one, or one that comes to the same
    const step = outcome.kind === "asked" || outcome.kind === "drawn" ? outcome.slot : -1;
    if (outcome.kind === "drawn") {
      task.results.delete(step);
      bench.made.delete(step);
      task.score.marks.delete(step);
      bench.again();
    }
    found.push(["instrument", move.it, outcome.kind === "none" ? outcome.answer.why : outcome.kind, step]);
    task.rest();
  }
  return found;
}

/** Tell wrong answers of a step: ten times a figure, a point 5 mm off, the other meeting; none of them stands after. */
function otherAnswers(session, slot) {
  const { bench, easel, task } = session;
  const due = bench.due(slot);
  const step = bench.log.steps.get(slot);
  if (hasSides(task, step)) {
    const side = bench.value(step.uses.find((one) => easel.kindOf(one) === "side"));
    return [["other side", slot, tellSide(task, -side) ? "" : "wrong", side]];
  }
  if (typeof due === "number") return Math.abs(due) < 1 ? [] : [["times ten", slot, refusal(session, slot, 10 * due), due]];
  const line = step.uses.map((one) => easel.values.line(one)).find((one) => one !== null);
  const [dx, dy] = line === undefined ? [5, 0] : [-5 * line.along[1], 5 * line.along[0]];
  const found = [["5 mm off", slot, refusal(session, slot, { re: due.re + dx, im: due.im + dy }), 5]];
  const side = step.uses.findIndex((one) => easel.kindOf(one) === "side");
  if (side < 0) return found;
  const values = step.uses.map((one, k) => (k === side ? -bench.run.values.get(one) : bench.run.values.get(one)));
  const other = done(step, values);
  const away = Math.hypot(other.re - due.re, other.im - due.im);
  return away < 5 ? found : [...found, ["other meeting", slot, refusal(session, slot, other), away]];
}

/** Tell a wrong answer; return how it is refused, "" if it is not. */
function refusal(session, slot, value) {
  const { task, bench } = session;
  const { verdict, missed } = told(session, slot, value);
  if (task.refused !== null) return missed && verdict !== "wrong" ? `missed, ${verdict}` : verdict;
  task.results.delete(slot);
  bench.made.delete(slot);
  bench.again();
  task.asked = task.own.get(slot);
  return "";
}

/** Draw a task badly, by chance; what is refused is left as it stands. Return the file of readings and how they are judged. */
function clumsy(page, n, seed) {
  const session = new Session(page, n);
  session.clear();
  const { task, bench, easel } = session;
  const chance = chances(seed);
  for (let step = open(session, 0); step !== undefined; step = open(session, 0)) {
    const { kind, slot } = laid(session, step);
    if (kind !== "asked" && kind !== "drawn") break;
    if (kind === "drawn") continue;
    if (hasSides(task, step)) {
      answer(session, slot);
      continue;
    }
    const due = bench.due(slot);
    const slip = [0, 0.2, 1, 8][Math.floor(4 * chance())];
    if (typeof due !== "number") told(session, slot, { re: due.re + slip * (chance() - 0.5), im: due.im + slip * (chance() - 0.5) });
    else told(session, slot, due * (1 + (slip * (chance() - 0.5)) / 50) * (chance() < 0.08 ? 10 : 1));
    task.leave();
  }
  const named = new Map([...bench.judged()].map(([slot, { verdict }]) => [session.row(slot, task.results.get(slot)), verdict]));
  const verdicts = [...named].map(([row, verdict]) => [row.plan, row.position, row.segment, verdict]);
  const { "csv head": head, "csv separator": separator } = page.words;
  const rows = session.readings().map((row) => spoken(row, easel.decimal));
  return { csv: csvOf(rows, head, separator), verdicts };
}

/** A row of readings with the decimal sign of the page, as it is typed there. */
function spoken(row, decimal) {
  return Object.fromEntries(
    Object.entries(row).map(([key, cell]) => [key, ["mm", "value", "x", "y"].includes(key) ? cell.replace(".", decimal) : cell]),
  );
}

/** Numbers of chance, from 0 to 1, the same for a seed. */
function chances(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
