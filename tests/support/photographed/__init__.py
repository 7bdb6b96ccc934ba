"""Photographs of a student's sheet, all of it known: pencil on paper, seen by a camera in a hand.

The points are where the hand ``student`` put them; all that is seen of them is made here: the ink of the SVG
drawn again as pencil (`pencil`), paper with its stains (`paper`), the camera and its light (`shooting`).
`taking` puts them together; `truth` says where every point stands, on the sheet and in the photograph.
"""
