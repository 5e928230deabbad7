"""Built-in parts of every node: parameter services, logger services, time source; and the clients of these."""
