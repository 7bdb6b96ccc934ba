"""Hard places of a drive, and how many digits of each result are left near them."""
