"""`topic`: inspect topics, subscribe and publish."""
