"""Message types: their text, their hash, their Python classes and their bytes."""
