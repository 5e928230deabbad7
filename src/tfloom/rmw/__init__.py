"""Bytes over a wire: topics, qualities of service, the graph, and the backends behind one interface (`base`)."""
