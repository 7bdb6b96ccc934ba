"""The drawing board: numpy only; knows no mechanisms and no paper."""
