"""`pkg`: packages of the workspaces and our own."""
