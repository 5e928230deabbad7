"""Programs about services."""
