"""What messages look like: from a message to shapes, without a browser.

- display, kinds, settings: what all have in common, which type has which, and what layouts may set
- point_cloud, depth_cloud, ranges, camera_info: sensors
- poses, wrench, occupancy_grid, markers: what programs compute
- robot_model, turtles: robots
"""
