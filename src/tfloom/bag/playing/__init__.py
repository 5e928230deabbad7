"""Playing: the node that publishes what a bag holds, at the pace of its log times."""
