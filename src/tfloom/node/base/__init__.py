"""A node without its built-in services: its names, its view of the graph, and the entities that it creates."""
