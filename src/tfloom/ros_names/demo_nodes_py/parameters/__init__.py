"""Programs about parameters."""
