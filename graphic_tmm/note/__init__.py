"""The explanatory note of a scene: a reader of its boards, written as PDF, DOCX, HTML and Markdown.

What is said stands in a document of blocks (`document`), made section by section (`section_*`) of what the log,
its readers and the chapters tell; `pandoc` writes the document, `tex` its formulas, `figures` its pictures.
"""
