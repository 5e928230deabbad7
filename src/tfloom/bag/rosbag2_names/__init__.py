"""The classes and functions of rosbag2_py, on the readers, writers, recorder and player of this room."""
