"""What tests share: mechanisms at random, oracles that know nothing of plans, drawn scenes."""
