"""What messages look like: from a message to shapes, without a browser.

- display, kinds: what all have in common, and which type has which
- point_cloud, ranges, camera_info: sensors
- poses, occupancy_grid, markers: what programs compute
- robot_model, turtles: robots
"""
