"""Example programs of the tutorials, and the demonstration.

- show, robot_show: the demonstrations: turtles, and a robot that maps its room
- program_group, processes, threads, child: their programs, as processes or on threads
- demo_nodes_py/, demo_nodes_cpp, turtle_tf2_py/: the programs of these packages
"""
