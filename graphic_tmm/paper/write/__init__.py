"""Sheets as files: SVG true to the millimetre, DXF, and PDF and PNG from the SVG."""
