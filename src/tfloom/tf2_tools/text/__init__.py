"""Counts, durations, dates and transforms as the tools print them."""
