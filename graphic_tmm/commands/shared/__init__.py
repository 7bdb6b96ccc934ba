"""What commands share: how they end, the options of several, what they print."""
