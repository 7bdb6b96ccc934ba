"""What the page says where a person draws, by the names that its program has for it; packed only with it."""

from __future__ import annotations

WORDS: dict[str, str] = {}
"""Braces are filled in by the page."""
