// The scheme of centres as a student works it who takes other lines than the log for a centre.
import { readFileSync, writeFileSync } from "node:fs";

const [, , asked, answered] = process.argv;
const { Session } = await import("./practice/session.js");
const answers = [];
for (const { written, data, words, n, steps } of JSON.parse(readFileSync(asked, "utf8"))) {
  await import(`./practice/${written}`);
  const session = new Session({ title: written, practice: data, words, views: [] }, n);
  session.clear();
  const { task, bench } = session;
  // a letter behind "*" is that of another plan
  const named = (letter) => {
    const slots = letter.startsWith("*") ? session.told.shown : [...task.own.keys(), ...session.told.shown];
    return slots.find((slot) => data.marks[slot].n === letter.replace("*", ""));
  };
  const taken = steps.map(([instrument, ...letters]) => {
    task.choose(instrument);
    let outcome = { kind: "more" };
    for (const letter of letters) outcome = task.pick(named(letter));
    if (outcome.kind === "more") outcome = task.submit();
    const found = [outcome.kind, data.marks[outcome.slot]?.n ?? ""];
    if (outcome.kind !== "asked") return found;
    const { re, im } = bench.log.exact.get(outcome.slot);
    const tried = task.tell({ re: Math.round(100 * re) / 100, im: Math.round(100 * im) / 100 }, ["", ""], { x: 0.005, y: 0.005 });
    return [...found, tried.verdict, tried.missed];
  });
  while (task.next !== null && taken.length < 99) {
    const { it } = task.next;
    task.take(it, null);
    taken.push(["next", data.marks[it].n]);
  }
  answers.push({ taken, ready: task.ready, score: task.score.tally(), done: task.results.size });
}
writeFileSync(answered, JSON.stringify(answers));
