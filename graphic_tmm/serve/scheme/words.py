"""What is said where a mechanism is drawn; braces are filled in by the script."""

from __future__ import annotations

from graphic_tmm.language.said import said

SCHEME_WORDS: dict[str, str] = {
    "scheme": said("Scheme"),
    "scheme draw": said("Draw a scheme"),
    "scheme paper": said(
        "The scheme: arrows move the cross, Enter begins and ends a link or chooses what is there, letters and "
        "figures name it, Delete takes it away, Ctrl with arrows moves the chosen pin, Space turns the drive"
    ),
    "scheme tools": said("What is put on the scheme"),
    "scheme support": said("Support"),
    "scheme slider": said("Slider"),
    "scheme stone": said("Stone on a bar"),
    "scheme cylinder": said("Cylinder"),
    "scheme point": said("Point of a link"),
    "scheme centre": said("Mass centre"),
    "scheme drive": said("Driving link"),
    "scheme weld": said("Weld", context="tool"),
    "scheme passive": said("Passive link"),
    "scheme undo": said("Take back"),
    "scheme redo": said("Do again"),
    "scheme delete": said("Delete"),
    "scheme picture": said("Picture below"),
    "scheme picture away": said("Take it away"),
    "scheme straighten": said("Straighten"),
    "scheme pale": said("How pale the picture is"),
    "scheme corner": said("Click corner {n} of 4 of a rectangle in the picture."),
    "scheme corners wrong": said("These are no four corners: click them again."),
    "scheme pdf": said("A browser shows no PDF here: save its page as a picture."),
    "scheme do support": said("Click the pin that the frame holds."),
    "scheme do slider": said("Drag from the pin that slides in the direction of its guide."),
    "scheme do stone": said("Click the pin of the stone."),
    "scheme stone bar": said("Click the bar along which the stone slides."),
    "scheme do cylinder": said("Drag from the pivot of the cylinder to the pin of its rod."),
    "scheme do point": said("Click the link that gets a point; then where its point is."),
    "scheme point place": said("Click where the point of link {number} is."),
    "scheme do centre": said(
        "Click the link where its mass centre is; a slider has it at its pin."
    ),
    "scheme do drive": said(
        "Click the link that is driven, a cylinder too, or one that is driven no more."
    ),
    "scheme do weld": said(
        "Click the pin at which two links become one, or are parted again; or one link, then the other."
    ),
    "scheme weld with": said("Click the link that is welded to link {number}, or parted from it."),
    "scheme do passive": said(
        "Click the link that only repeats what others hold, or one that counts again."
    ),
    "scheme joined": said("joined with {letter}"),
    "scheme on link": said("on link {number}"),
    "scheme same link": said("These are one pin, or on one link already."),
    "scheme nothing": said("That cannot be done here."),
    "scheme both on": said("One link has both {a} and {b} ({link}): they cannot become one pin."),
    "scheme glued": said("Two values stand here: write one, or a blank before the sign of a sum."),
    "scheme not there": said("It cannot be assembled there."),
    "scheme chosen pin": said(
        "{letter} is chosen: drag it, type its letter, or take what it shall be above."
    ),
    "scheme chosen link": said("Link {number} is chosen: type its number, or its lengths beside."),
    "scheme begun": said(
        "Move the cross, and press Enter where it ends; on the same place it is chosen. Escape leaves it."
    ),
    "scheme begin": said("Draw a link: drag from one of its pins to the other."),
    "scheme frame": said("frame"),
    "scheme pin of": said("Pin {letter} of: {links}"),
    "scheme link of": said("Link {number}: {letters}"),
    "scheme letter": said("Letter", context="of a pin"),
    "scheme number": said("Number", context="of a link"),
    "scheme lengths": said("Lengths"),
    "scheme scaled": said(
        "The drawing was scaled to {length} = {text}: other lengths went with it."
    ),
    "scheme next": said("What the task gives next"),
    "scheme named": said("{name} stands in several places: change it"),
    "scheme add": said("Add what the task gives besides …"),
    "scheme add it": said("Add it"),
    "scheme added": said("Added: {what}"),
    "scheme where": said("where", context="of a table"),
    "scheme how much": said("how much", context="of a table"),
    "scheme everywhere": said("everywhere"),
    "scheme here": said("here alone"),
    "scheme turn": said("The drive through its turn"),
    "scheme play": said("Turn it"),
    "scheme save": said("Save as a scene"),
    "scheme title": said("Title"),
    "scheme not whole": said("It is saved when nothing is missing any more."),
    "scheme changed": said(
        "The file has changed meanwhile: it is shown as it is now, and this was not done."
    ),
    "scheme how": said("How it is drawn"),
    "scheme how text": said(
        "Drag on the paper: a link with two pins. What begins or ends on a pin is joined with it, on a bar it "
        "is a point of that link. A click chooses; a chosen pin is dragged. Alt: no whole millimetres, no "
        "steps of 15°. The wheel, or two fingers, zoom; the right button moves the paper."
    ),
    "scheme keys": said(
        "Keys: arrows move the cross, Enter begins and ends, a letter names the chosen pin, a figure numbers "
        "the chosen link, Ctrl+Z takes back, Ctrl+arrows move the chosen pin, Delete, Space turns, Escape "
        "leaves."
    ),
    "mm": said("mm", context="unit"),
}
