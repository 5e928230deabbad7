"""Loggers: severities, levels, filters, and the outputs of records."""
