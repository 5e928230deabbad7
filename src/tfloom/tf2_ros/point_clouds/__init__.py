"""Point clouds as arrays, and their transformation."""
