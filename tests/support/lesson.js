// Looks at a page from within, by what its parts are called.
const UNREADABLE =
  /\bNaN\b|\bundefined\b|\bnull\b|\bInfinity\b|\[object|\d[eE][-+−]\d|10⁻¹[1-9]|[{}]|(?:^|[=≈:]\s*)—(?=\s*(?:$|[,;·]))/mu;

/** What a part is called: its label, or what stands on it. */
function called(part) {
  const other = document.getElementById(part.getAttribute("aria-labelledby") ?? "");
  return other?.textContent.trim() ?? part.getAttribute("aria-label") ?? part.textContent.trim();
}

function button(name) {
  const found = [...document.querySelectorAll("button")].find((one) => called(one) === name);
  if (found === undefined) throw new Error(`no button ${name}`);
  return found;
}

/** The choice behind a label. */
function choice(name) {
  const named = (one) => [...(one.labels ?? [])].some((label) => label.textContent.trim().startsWith(name));
  return [...document.querySelectorAll("select")].find((one) => named(one) && one.checkVisibility());
}

function choose(select, value) {
  select.value = value;
  select.dispatchEvent(new Event("change", { bubbles: true }));
}

function values(select) {
  return select === undefined ? [] : [...select.options].map((one) => one.value);
}

function room(names) {
  const rooms = [...document.querySelectorAll("section, [role=tabpanel]")];
  return rooms.find((one) => called(one) === names.play);
}

/** The drawing of the plan that is played. */
function drawing(names) {
  return room(names).querySelector("svg[role=img], svg[role='graphics-document']");
}

/** What is told with the picture that is shown. */
function telling(names, kinds = "p, dd") {
  const told = room(names).querySelector(".telling");
  const lines = told === null ? [] : [...told.querySelectorAll(kinds)];
  return lines.map(textOf);
}

/** The text of a part in one line; an index stands behind a "_", as in the protocol. */
function textOf(part) {
  const copy = part.cloneNode(true);
  for (const index of copy.querySelectorAll("sub")) index.prepend("_");
  for (const power of copy.querySelectorAll("sup")) power.prepend("^");
  return copy.textContent.replace(/\s+/gu, " ").trim();
}

/** The tables that stand beside the drawing: of each its caption, its rows as texts of cells. */
function tables(names) {
  const rows = (table) => [...table.rows].map((row) => [...row.cells].map(textOf));
  const seen = [...room(names).querySelectorAll("table")].filter((one) => one.checkVisibility());
  return seen.map((one) => [textOf(one.caption ?? one), rows(one)]);
}

/** Play what is chosen from its first picture to its last. */
function played(names) {
  const next = button(names.next);
  const hidden = new Set([...room(names).querySelectorAll("svg")]);
  const seen = () => {
    const parts = [...room(names).querySelectorAll("p, li, button, td, th, dd, output, option")];
    return parts.filter((one) => ![...hidden].some((svg) => svg.contains(one))).map((one) => one.textContent);
  };
  const faults = new Set();
  const lines = [];
  const readings = [];
  const pictures = new Set();
  button(names.first).click();
  const address = location.hash;
  for (let before = ""; before !== location.hash; next.click()) {
    before = location.hash;
    lines.push(telling(names, "p:not(.reading, .tool, .remark)"));
    readings.push(...telling(names, ".reading"));
    pictures.add(drawing(names).dataset.picture);
    for (const text of lines.at(-1)) {
      const found = UNREADABLE.exec(text);
      if (found !== null) faults.add(`${location.hash}: ${text}`);
    }
  }
  for (const text of seen()) if (UNREADABLE.test(text)) faults.add(text);
  const bar = textOf(room(names).querySelector("[role=toolbar]"));
  const count = /\d+(?=\D*$)/u.exec(bar)?.[0] ?? "";
  const title = called(drawing(names));
  const stops = lines.length - 1;
  const told = { title, count, address, lines, readings, tables: tables(names), faults: [...faults] };
  return { ...told, pictures: pictures.size, stops };
}

function walk(names) {
  const found = [];
  for (const plan of values(choice(names.plan))) {
    choose(choice(names.plan), plan);
    const places = values(choice(names.position));
    for (const place of places.length > 0 ? places : [null]) {
      if (place !== null) choose(choice(names.position), place);
      found.push(played(names));
    }
  }
  return found;
}

/** Go to a view by its address, to its end; tell where its drawing stands (px), what part of the sheet it shows (mm). */
function atTheEnd(names, address) {
  location.hash = address;
  return new Promise((done) => {
    addEventListener("hashchange", () => {
      button(names.last).click();
      const found = drawing(names);
      const { x, y, width, height } = found.getBoundingClientRect();
      done({ rect: { x, y, width, height }, box: found.viewBox.baseVal === null ? null : found.getAttribute("viewBox") });
    }, { once: true });
  });
}
