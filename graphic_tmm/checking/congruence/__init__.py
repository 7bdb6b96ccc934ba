"""Before a drawing is judged: in which scale factor each plan was drawn, how turned, from where counted."""
