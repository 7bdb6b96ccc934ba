"""Marks for a class: every hand-in checked as it would be alone, by a rule that the teacher states.

::

    folder --names--> hand-ins --judging (works of the batch)--> row, figures, report of each
                                                                 |
       summary.csv .xlsx .html, gradebook.csv  <--tables, page-- rows, marks (rule), alike, other variants

A row is what one hand-in comes to; it is found by that hand-in alone, so it may be found anywhere, and is not
found again while nothing changed. What needs two hand-ins, who is like whom and whose variant it is, is told
beside the rows, and is never part of a mark.
"""
