"""Recording: the node that subscribes to topics and writes what it receives into a bag."""
