"""The report: one page with all that a study gave."""
