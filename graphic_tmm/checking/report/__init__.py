"""What a check found, told: as text, Markdown, HTML (templates) and JSON, with a chart of the deviations."""
