"""Launch descriptions in files."""
