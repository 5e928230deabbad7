"""`lifecycle`: nodes that are configured, activated and shut down from outside."""
