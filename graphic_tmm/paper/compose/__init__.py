"""Views composed onto sheets as a master sets them: blocks in order, equal gaps, nothing scaled.

What stands together is said by the views (`Stand`): the views of a block make a unit (`units`), units are cut
into a sheet by vertical and horizontal cuts that keep their order (`slicing`: first left and above, last right
and below, where the title block is), and the room that is left goes into the gaps (`spread`). `sheet` composes
one sheet in a given order, `search` tries orders, `sheets` composes several sheets.

All of it works on boxes (`Outline`), so whoever chooses sizes asks without drawing: `search.fits` whether a
sheet holds some (a millisecond for fifty views), `sheets.shared` how many sheets a set takes (some ten),
`sheets.composed` where everything stands. A box is a view's `Outline.of`, or an outline of any width and height
with the `Stand` that the view declares. The same sizes always make the same sheets.
"""
