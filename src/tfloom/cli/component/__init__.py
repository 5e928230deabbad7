"""`component`: the nodes that containers hold."""
