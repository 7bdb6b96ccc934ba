"""What is given: links, pairs, their structure, and mechanisms found from a task."""
