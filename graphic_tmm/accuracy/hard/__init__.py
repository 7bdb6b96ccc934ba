"""Hard places of a turn, and how many digits of each result are left near them."""
