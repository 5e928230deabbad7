"""Interface definitions."""
