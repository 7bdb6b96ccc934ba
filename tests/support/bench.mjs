// The benches of many scenes, worked by node: what is asked for stands in a file, what is answered in another.
import { readFileSync, writeFileSync } from "node:fs";

const [, , asked, answered] = process.argv;
const { Bench } = await import("./practice/bench.js");
const { Log, done } = await import("./practice/log.js");
const { Judging } = await import("./practice/judging.js");
const { seenOf, shareOfSlip } = await import("./practice/limits.js");
const answers = [];
for (const { written, data, drawings, together, work } of JSON.parse(readFileSync(asked, "utf8"))) {
  await import(`./practice/${written}`);
  // MORE
  answers.push({
    worked: work.map((task) => all(data, data.tasks[task])),
    judged: drawings.map(({ task, manner, rows }) => judged(new Bench(data, data.tasks[task], manner), rows)),
    together: together.map((plans) => judgedTogether(data, plans)),
  });
}
writeFileSync(answered, JSON.stringify(answers));

/** A task: what the exact hand has of it; worked in two orders; worked wrongly. */
function all(data, task) {
  const exact = exactly(new Bench(data, task));
  return { task, exact, solved: [solved(data, task, false), solved(data, task, true)], failed: failed(new Bench(data, task)) };
}

/** What the exact hand has of every mark. */
function exactly(bench) {
  return Object.fromEntries([...bench.log.exact].map(([slot, value]) => [slot, numbers(value)]));
}

/** Work a task by its own due answers, first or last of what is open first; return what is not as it should be. */
function solved(data, task, last) {
  const bench = new Bench(data, task);
  const faults = [];
  const order = [];
  for (let open = bench.open(); open.length > 0; open = bench.open()) {
    const slot = open[last ? open.length - 1 : 0];
    const step = bench.log.steps.get(slot);
    const due = bench.due(slot);
    const match = bench.match(step.op, step.uses, step.choice);
    if (match.slot === undefined) faults.push([slot, "match", match]);
    const { verdict } = bench.judge(slot, due);
    if (verdict !== "fine") faults.push([slot, verdict]);
    bench.take(slot, due);
    order.push(slot);
  }
  if (order.length !== task.steps.length) faults.push(["left", task.steps.filter((slot) => !order.includes(slot))]);
  for (const one of bench.judged().values()) if (one.verdict !== "fine") faults.push([one.slot, one.verdict, "at the end"]);
  return { faults, order };
}

/** Work a task rightly, but at every step first wrongly; return the verdicts: [mark, kind of mistake, verdict, mm]. */
function failed(bench) {
  const told = [];
  for (const slot of bench.task.steps) {
    const step = bench.log.steps.get(slot);
    const due = bench.due(slot);
    for (const [kind, found] of wrongly(bench, step, due)) {
      const apart = typeof due === "number" ? Math.abs(found - due) : Math.hypot(found.re - due.re, found.im - due.im);
      told.push([slot, kind, bench.judge(slot, found).verdict, apart]);
    }
    bench.take(slot, due);
  }
  return told;
}

/** What may be found wrongly: ten times too much, 5 mm off, at the other meeting. */
function* wrongly(bench, step, due) {
  if (typeof due === "number") yield ["ten times", 10 * due];
  else if ("re" in due) {
    for (const turn of [0.3, 1.9, 3.4, 5.1]) yield ["5 mm", { re: due.re + 5 * Math.cos(turn), im: due.im + 5 * Math.sin(turn) }];
    const side = step.uses.findIndex((slot) => bench.data.marks[slot].k === "side");
    const values = step.uses.map((slot) => bench.run.values.get(slot));
    if (side >= 0) yield ["other meeting", done(step, values.map((value, k) => (k === side ? -value : value)))];
  }
}

/** Judge plans of one drawing whose points were read: each of a task, rows as those of a drawing. */
function judgedTogether(data, plans) {
  const read = plans.map(({ task, rows }) => ({ plan: data.tasks[task].plan, rows: rows.map(row) }));
  const judgings = plans.map(({ task }, k) => {
    const others = read.filter((_, n) => n !== k);
    const log = new Log(data, data.tasks[task].at);
    return new Judging(log, data.tasks[task], data.manners.points, read[k].rows, others);
  });
  const share = shareOfSlip(judgings.flatMap(seenOf), data.reader);
  return judgings.flatMap((one) => {
    one.share = share;
    return [...one.all().values()].map(plainly);
  });
}

/** Judge a drawing: rows of a slot, what was found, half units of the last digits. */
function judged(bench, rows) {
  for (const { slot, found, last } of rows.map(row)) bench.take(slot, found, last);
  return [...bench.judged().values()].map(plainly);
}

/** A row as benches take it. */
function row([slot, found, last]) {
  return { slot, found: Array.isArray(found) ? { re: found[0], im: found[1] } : found, last };
}

/** A judgement as data. */
function plainly({ slot, error, parts, verdict, blamed, deviation }) {
  return { slot, error, parts: parts.map((part) => [part.slot, part.error]), verdict, blamed, deviation };
}

/** The numbers that a mark is made of. */
function numbers(value) {
  if (typeof value === "number") return [value];
  if ("re" in value) return [value.re, value.im];
  return Object.values(value).flatMap(numbers);
}
