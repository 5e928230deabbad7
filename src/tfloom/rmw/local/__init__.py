"""The wire inside one process: a whole system can run on it without a network."""
