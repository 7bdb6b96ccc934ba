"""Task sheets without their solution, and keys apart from them."""
