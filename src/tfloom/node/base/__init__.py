"""A node without its built-in services: its names, what it sees of the graph, what it creates."""
