"""Programs about topics."""
