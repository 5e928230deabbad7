"""Frames over time, with no ROS types.

- buffer, arrays, transform, velocity, frames, trajectory: the classes of the public interface
- errors: the exceptions of a lookup
"""
