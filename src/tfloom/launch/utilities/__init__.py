"""Checks and conversions of arguments, which several classes share."""
