"""`node`: inspect nodes."""
