"""Message types: definitions, type hashes, Python classes and the codec."""
