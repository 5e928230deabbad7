"""The programs of demo_nodes_py: the smallest nodes that talk, listen, serve and ask."""
