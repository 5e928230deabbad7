"""Programs about logging."""
