"""Loggers: severities, levels, and where records go."""
