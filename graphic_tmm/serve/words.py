"""What the studio says, by the names that its scripts have for it."""

from __future__ import annotations

from graphic_tmm.language.said import said

WORDS: dict[str, str] = {
    "sheets": said("Sheets"),
    "page": said("Plans step by step"),
    "values": said("Values"),
    "files": said("Files"),
    "scenes": said("Scenes"),
    "dark": said("Dark or light"),
    "ways": said("Ways to look at the scene"),
    "sheet": said("Sheet {n}"),
    "page of": said("The plans of the scene, step by step"),
    "no page": said("The page is being made."),
    "page failed": said("The page could not be made."),
    "no sheets": said("There is no sheet yet."),
    "larger": said("Larger"),
    "smaller": said("Smaller"),
    "whole": said("The whole sheet"),
    "true size": said("True size"),
    "desk": said(
        "The sheets: arrows move them, + and − zoom, 0 shows a sheet whole, 1 in its true size"
    ),
    "drawing": said("It is being drawn …"),
    "drawn": said("Drawn as the file says."),
    "faults": said("Faults: {n}. The sheets are those of before."),
    "faults first": said("Faults: {n}. Nothing could be drawn yet."),
    "faults page": said("Faults: {n}. The sheets are as the file says, the page is not."),
    "faults head": said("What is wrong"),
    "warnings head": said("What to know"),
    "line": said("line {line}"),
    "lost": said(
        "The connection is lost; it is tried again. If the studio has ended, begin it again, and open "
        "the address that it tells."
    ),
    "mended": said("The connection is there again."),
    "written": said("{key}: written into the file."),
    "refused": said("{key}: refused."),
    "conflict": said(
        "The file was changed meanwhile. It has {text} here now; yours was not written: Enter writes it."
    ),
    "nothing there": said("nothing"),
    "not sent": said("It could not be sent; Enter tries again."),
    "no form": said("The file is no TOML: there are no values to set. Mend it in your editor."),
    "fixed": said("A scene of the package is not changed; copy it to a folder of yours first."),
    "find": said("Find a value"),
    "more": said("What else may be written"),
    "default": said("else {default}"),
    "usual": said("as usual"),
    "needed": said("has to be written"),
    "on": said("yes"),
    "off": said("no"),
    "form keys": said("Enter writes a value into the file, Escape takes back what was typed."),
    "fine": said("without faults"),
    "waiting": said("not drawn yet"),
    "scene faults": said("faults: {n}"),
    "no scenes": said("There is no scene in this folder."),
    "no scripts": said("The studio needs scripts: allow them for this address."),
}
"""Braces are filled in by the script."""
FILES: dict[str, str] = {
    "svg": said("Sheets (SVG)"),
    "pdf": said("Sheets (PDF)"),
    "png": said("Sheets as pictures (PNG)"),
    "dxf": said("Sheets for CAD (DXF)"),
    "html": said("Page for a browser (HTML)"),
    "csv": said("Tables (CSV)"),
    "note": said("Explanatory note (DOCX)"),
    "toml": said("The scene (TOML)"),
}
"""What files of a format are called; one that is not named here is called by its format."""
