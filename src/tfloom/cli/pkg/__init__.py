"""`pkg`: packages of sourced workspaces, and tfloom's own."""
