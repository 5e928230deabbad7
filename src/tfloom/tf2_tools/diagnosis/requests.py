"""The frames in the requests that clients send to buffer servers."""

from __future__ import annotations

from tfloom.rmw.base import Sample
from tfloom.rmw.cyclone.graph import FAST_DDS
from tfloom.rosidl import cdr

_ENCAPSULATION_SIZE = 4
_HEADER_SIZE = 16
"""Of a request in the form of rmw_cyclonedds: the client's key and a sequence number, 8 bytes each."""


def requested_frames(sample: Sample) -> list[str]:
    """Return the frames that a request of `tf2_msgs/action/LookupTransform` names; none if it can't be decoded."""
    from tfloom.interfaces.tf2_msgs.action import LookupTransform_SendGoal_Request

    data = sample.data
    if not sample.publisher_gid.startswith(FAST_DDS):
        data = data[:_ENCAPSULATION_SIZE] + data[_ENCAPSULATION_SIZE + _HEADER_SIZE :]
    try:
        goal = cdr.decode(LookupTransform_SendGoal_Request, data).goal
    except cdr.DecodeError:
        return []
    frames = [goal.target_frame, goal.source_frame, *([goal.fixed_frame] if goal.advanced else [])]
    return list(dict.fromkeys(frames))
