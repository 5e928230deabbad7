"""The programs of demo_nodes_py: minimal publishers, subscriptions, servers and clients."""
