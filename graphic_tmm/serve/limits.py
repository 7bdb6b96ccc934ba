"""What a server of scenes does at most: bytes, seconds, memory, how much it keeps."""

from __future__ import annotations

LOOPBACK = ("127.0.0.1", "localhost", "::1")
"""The names by which a computer asks itself."""
BODY = 256_000
"""So many bytes a body that is sent may have, as a scene's file."""
BODY_TIME = 5.0
"""A body has come by then, s."""
PHOTO = 60_000_000
"""So many bytes a photograph may have that is sent."""
PHOTO_TIME = 60.0
"""It has come by then, s: a telephone sends it over the air."""
CLICKED = 20_000
"""So many characters may tell what was clicked in it."""
BEGINNING = 120.0
"""A process that draws has loaded what it needs by then, s."""
DRAWING = 60.0
"""A drawing, or the page of one, may take so long, s of the processor; a page of forty plans takes 20."""
JUDGING = 10.0
"""So may a text that is read, and changed by a form."""
DOWNLOAD = 180.0
"""So may all files of a format: a note of forty plans is set twice."""
MEMORY = 4_000_000_000
"""Of the process that draws, bytes, where the system can hold it to that."""
KEPT, KEPT_BYTES = 60, 80_000_000
"""So many sheets and pages of a scene are kept for browsers that still ask for them, and so many bytes."""
STREAMS = 40
"""So many browsers may follow at once."""
BEAT = 15.0
"""A browser that follows hears something at least so often, s."""
SCENES = 200
"""So many scenes of a folder are shown."""
LINE = 200
"""So many characters of a line are shown beside what is wrong in it."""
CONNECTIONS = 200
"""So many connections are answered at once."""
WAITING = 1000
"""So many tasks may wait for a worker."""
