"""How the pages of a note look: of HTML (CSS) and of PDF (typst); margins and sizes by ГОСТ 2.105 and 7.32."""

from __future__ import annotations

CSS = """\
:root { color-scheme: light; }
body { margin: 0; background: #fff; color: #111; font: 17px/1.5 "Times New Roman", "Liberation Serif", serif; }
main { max-width: 48rem; margin: 0 auto; padding: 2rem 1rem; }
h1 { font-size: 1.5rem; margin: 2.5rem 0 1rem; } h2 { font-size: 1.2rem; } h3 { font-size: 1.05rem; }
h1.unnumbered { text-align: center; }
figure { margin: 1.5rem 0; text-align: center; }
figure svg { max-width: 100%; height: auto; }
figcaption { text-align: center; }
.wide { max-width: 100%; overflow-x: auto; margin: 1.5rem 0; }
table { border-collapse: collapse; }
caption { text-align: left; margin-bottom: .3rem; white-space: nowrap; }
th, td { border: 1px solid #555; padding: .15rem .4rem; font-size: .85rem; font-weight: normal; }
table.unruled th, table.unruled td { border: 0; font-size: 1rem; }
math.wide { margin: 0; overflow-y: hidden; }
math.wide[display="inline"] { display: inline-block; vertical-align: middle; }
math[display="block"] { margin: .6rem 0; }
p { margin: .5rem 0; } li > p { margin: .2rem 0; }
ul { list-style: none; padding-left: 1.2rem; }
a { color: #0b4a8f; }
.centre, .title { text-align: center; }
.title { font-size: 1.6rem; font-weight: bold; margin: 2rem 0 1rem; }
.space { height: 2rem; }
@media (max-width: 48rem) { caption { white-space: normal; } }
@media print { main { max-width: none; padding: 0; } h1 { break-after: avoid; } }
@media print { figure { break-inside: avoid; } }
"""
"""Of HTML: dark on white, nothing wider than the window: tables and formulas move in boxes of their own."""

TYPST = """\
#set page(
  paper: "a4",
  margin: room,
  numbering: "1",
  footer: context if not framed and here().page() > 1 { align(center, counter(page).display("1")) },
  background: context if drawn and here().page() > 1 {
    image("frame-" + str(here().page()) + ".svg", width: 210mm, height: 297mm)
  },
)
#set text(
  font: ("Libertinus Serif", "New Computer Modern"),
  size: 12pt,
  top-edge: 0.75em,
  bottom-edge: -0.25em,
  hyphenate: true,
)
#set par(leading: apart, spacing: apart, justify: true, first-line-indent: (amount: 12.5mm, all: true))
#set enum(indent: 6mm, body-indent: 2mm)
#set list(marker: [–], indent: 6mm, body-indent: 2mm)
#set table(stroke: 0.5pt, inset: (x: 2pt, y: 1.3pt))
#set table.hline(stroke: 0.5pt)
#show table: set text(size: 10pt, hyphenate: false)
#set table.cell(breakable: false)
#show table: set par(justify: false, leading: 0.1em, spacing: 0.1em, first-line-indent: 0mm)
#show figure: set block(breakable: true, above: 0.8em, below: 0.8em)
#let continued(to, told) = context {
  let (first,) = query(to)
  if here().page() > first.location().page() {
    pad(bottom: 3pt, text(size: 12pt, told))
  }
}
#show figure.where(kind: table): set figure.caption(position: top)
#show figure.where(kind: table): set align(left)
#show figure.where(kind: image): set block(breakable: false)
#show figure.caption: it => {
  set par(first-line-indent: 0mm, justify: false, leading: 0.15em)
  set text(size: 12pt, hyphenate: false)
  set align(if it.kind == table { left } else { center })
  block(sticky: true, width: 100%, it.body)
}
#show math.equation.where(block: true): set block(above: 0.55em, below: 0.55em, breakable: true)
#show math.equation: set text(font: "New Computer Modern Math")
#show heading: set text(hyphenate: false)
#show heading: set par(justify: false, first-line-indent: 0mm, leading: 0.2em)
#show heading: set block(above: 0.9em, below: 0.6em)
#show heading.where(level: 1): set text(size: 14pt)
#show heading.where(level: 2): set text(size: 13pt)
#show heading.where(level: 3): set text(size: 12pt, style: "italic", weight: "regular")
#show link: set text(fill: black)
#let contents(title) = {
  set page(margin: (..room, bottom: low))
  align(center, text(size: 16pt, weight: "bold", title))
  set text(size: 12pt)
  set par(leading: 0.2em, spacing: 0.2em)
  outline(title: none, depth: 2, indent: 6mm)
  pagebreak(weak: true)
}
#let centred(told) = {
  set par(justify: false, first-line-indent: 0mm)
  align(center, text(hyphenate: false, told))
}
#let bare(told) = {
  set table(stroke: none)
  show table: set text(size: 12pt)
  told
}
#let beside(..parts) = grid(
  columns: parts.pos().len(),
  column-gutter: 5mm,
  align: center + bottom,
  ..parts.pos(),
)
#let ragged(told) = {
  set par(justify: false)
  told
}
#let leading(told) = block(sticky: true, above: apart, below: apart, told)
#let part(told) = align(center, told)
#let together(told) = block(breakable: false, above: apart, below: apart, told)
#let whole(told) = {
  show figure: set block(breakable: false)
  told
}
#show enum: it => block(breakable: false, {
  show math.equation.where(block: true): set align(left)
  it
})
#let great(told) = centred(text(size: 18pt, weight: "bold", told))
"""
"""Of PDF: what pandoc writes for typst is set by it; `apart` is the white between two lines of text."""
APART = {"ru": "0.5em"}
"""Lines stand one and a half sizes apart in Russian notes (ГОСТ 7.32)."""
NEARER = "0.25em"
"""White between lines in others."""
