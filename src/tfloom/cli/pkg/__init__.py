"""`pkg`: packages of sourced workspaces and of tfloom."""
