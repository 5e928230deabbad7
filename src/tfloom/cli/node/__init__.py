"""`node`: ask about nodes."""
