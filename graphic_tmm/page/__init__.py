"""The teaching page: any scene in a browser, step by step; Python writes every text, the browser shows."""

FORMAT = "html"
"""What files of pages are called."""
