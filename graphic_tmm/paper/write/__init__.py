"""Sheets as files: SVG true to the millimetre, DXF, and PDF and PNG made of the SVG."""
