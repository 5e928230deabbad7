"""The classes and functions of PyKDL for geometry, and their way from and to `tfloom.tf2`'s transforms.

A value can be changed in place, and so can its parts: after `p = F.p; p[0] = 1.0`, `F.p[0]` is 1.0. Values that differ
by less than 1e-6 are equal, therefore they have no hash. Angles are in radians.
"""

from __future__ import annotations

from tfloom._native import Frame, Rotation, Transform, Twist, Vector, Wrench
from tfloom._native import kdl_add_delta as addDelta
from tfloom._native import kdl_diff as diff
from tfloom._native import kdl_dot as dot
from tfloom._native import kdl_equal as Equal
from tfloom._native import kdl_set_to_zero as SetToZero

__all__ = [
    "Equal",
    "Frame",
    "Rotation",
    "SetToZero",
    "Twist",
    "Vector",
    "Wrench",
    "addDelta",
    "diff",
    "dot",
    "frame_of",
    "transform_of",
]

__version__ = "1.5.1"  # of the PyKDL whose interface this is

for _class in (Frame, Rotation, Twist, Vector, Wrench):
    _class.__module__ = "PyKDL"  # so that pickled values can be read with either


def frame_of(transform: Transform) -> Frame:
    """Return a transform as a Frame of the same name, parent_from_child."""
    return Frame(Rotation.Quaternion(*transform.rotation_xyzw), Vector(*transform.translation))


def transform_of(frame: Frame) -> Transform:
    """Return a Frame as a transform.

    Raises:
        ValueError: the frame's matrix has no rotation, as one of zeros.
    """
    return Transform(tuple(frame.p), frame.M.GetQuaternion())
