"""The commands, one a file.

To add one, write `name.py` here with a click command called `name`: the command line finds it by its being
there, and its first sentence stands in ``graphic-tmm --help``. A file imports heavy packages inside its
command, so that help stays light; what several commands need is in `shared`.
"""
