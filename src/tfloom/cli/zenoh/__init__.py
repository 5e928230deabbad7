"""`zenoh`: the router of the Zenoh wire."""
