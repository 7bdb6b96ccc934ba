"""The book: every chapter a folder that can be deleted; nobody outside names one."""
