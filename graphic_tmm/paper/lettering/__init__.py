"""The own stroke lettering on the grid of ГОСТ 2.304: glyphs by alphabet, indices, mark-up."""
