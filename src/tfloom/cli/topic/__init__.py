"""`topic`: ask about topics, listen and publish."""
