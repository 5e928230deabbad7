"""Example programs of the tutorials, and the demonstration.

- show: the demonstration, its programs as processes or on threads
- demo_nodes_py/, demo_nodes_cpp/, turtle_tf2_py/: the programs of these packages
"""
