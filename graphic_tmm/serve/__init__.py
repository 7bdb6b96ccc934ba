"""A studio in the browser: a scene's sheets and page follow its file as it is edited; a folder as a gallery.

Who asks is not trusted: a token in the address, the name of the host, sizes and times are held to `limits`.
What a scene says is not trusted either: it is drawn in a process of its own (`worker.py`) that is given the
text and no file, and is ended when it takes too long. Files are found by name in `folder.py` alone, never by
what an address says.

    folder.py --text--> desk.py --task--> worker.py, jobs.py --sheets, page--> kept.py --> routes.py
    what is there       when to draw      another process                     by hash     to browsers
        ^                  ^                                                                  |
        +-- desk.watch ----+   which files have changed               shell.py, web/ <--------+
        |                                                             what a browser shows
        +---- edit.py, form.py   the values of a file as fields, set in it again
"""
