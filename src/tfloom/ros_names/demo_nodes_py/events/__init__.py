"""Programs about events."""
