"""Nodes for plug-ins of the command and for programs: on the graph for a block, with discovery complete."""
