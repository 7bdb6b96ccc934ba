// The benches of many scenes, worked by node: what is asked for stands in a file, what is answered in another.
import { readFileSync, writeFileSync } from "node:fs";

const [, , asked, answered] = process.argv;
const { Bench } = await import("./practice/bench.js");
const answers = [];
for (const { written, data, drawings } of JSON.parse(readFileSync(asked, "utf8"))) {
  await import(`./practice/${written}`);
  answers.push({
    exact: data.tasks.map((task) => exactly(new Bench(data, task))),
    solved: data.tasks.map((task) => [solved(data, task, false), solved(data, task, true)]),
    judged: drawings.map(({ task, manner, rows }) => judged(new Bench(data, data.tasks[task], manner), rows)),
  });
}
writeFileSync(answered, JSON.stringify(answers));

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

/** Judge a drawing: rows of a slot, what was found, half units of the last digits. */
function judged(bench, rows) {
  for (const [slot, found, last] of rows) bench.take(slot, Array.isArray(found) ? { re: found[0], im: found[1] } : found, last);
  return [...bench.judged().values()].map(({ slot, error, parts, verdict, blamed, deviation }) =>
    ({ slot, error, parts: parts.map((part) => [part.slot, part.error]), verdict, blamed, deviation }));
}

/** The numbers that a mark is made of. */
function numbers(value) {
  if (typeof value === "number") return [value];
  if ("re" in value) return [value.re, value.im];
  return Object.values(value).flatMap(numbers);
}
