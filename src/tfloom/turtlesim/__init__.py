"""The turtle simulator: its world, the world's picture, and its programs.

- world: physics, without ROS and without a picture
- canvas, art, picture: drawing
- window: display
- node, teleop_key, record: the programs
"""
