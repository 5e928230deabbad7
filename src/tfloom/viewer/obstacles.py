"""Why a display can't be drawn, or is drawn where it was at another time: one sentence for each cause."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.rmw.shared.qos_mismatch import differences
from tfloom.tf2.errors import ExtrapolationException, TransformException
from tfloom.tf2_tools.diagnosis.subject import near_frame
from tfloom.tf2_tools.text import seconds_text
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.frames import root_of
from tfloom.viewer.page_command import fault_text

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from tfloom.rmw.base import EndpointInfo
    from tfloom.rmw.qos import QoS
    from tfloom.tf2.buffer import Buffer
    from tfloom.viewer.shapes import Placed

__all__ = [
    "MAX_STATUS",
    "PATIENCE_NS",
    "lag_text",
    "message_text",
    "other_type_text",
    "qos_text",
    "thing_of",
    "transform_text",
]

PATIENCE_NS = 1_000_000_000
"""How long transforms may be behind a message until it is shown without them, which is then said [ns]."""
MAX_STATUS = 600
"""Length of a sentence [characters]."""
MAX_NAME = 80
"""Length of a name in it [characters]: the end of the sentence is to be read, too."""
THINGS = {
    "PointCloud2": "the cloud",
    "PointCloud": "the cloud",
    "DepthCloud": "the cloud",
    "LaserScan": "the scan",
    "Range": "the range",
    "Camera": "the camera",
    "Marker": "a marker",
    "MarkerArray": "a marker",
    "InteractiveMarkers": "a marker",
    "Path": "the path",
    "Odometry": "the odometry",
    "Map": "the map",
    "GridCells": "the grid",
    "Pose": "the pose",
    "PoseWithCovariance": "the pose",
    "PoseArray": "the array of poses",
    "PointStamped": "the point",
    "Polygon": "the polygon",
    "Wrench": "the wrench",
    "TwistStamped": "the twist",
    "Effort": "the effort",
    "Turtle": "the turtle",
    "RobotModel": "a link",
    "Grid": "the grid",
}
"""What is in a frame, by the label of its display."""


def thing_of(label: str) -> str:
    """Return what a kind of display draws, with its article."""
    return THINGS.get(label, "the message")


def _quoted(name: str) -> str:
    return f"`{shown_text(name, MAX_NAME)}`"


def transform_text(
    error: Exception, buffer: Buffer, fixed_frame: str, frame: str, held_ns: int | None, thing: str
) -> str:
    """Return why nothing leads from a frame to the fixed one.

    Args:
        error: What the buffer or the drawing raised.
        buffer: The transforms.
        fixed_frame: The fixed frame.
        frame: The frame of what can't be drawn, without a leading slash.
        held_ns: The time that the page shows [ns since epoch]; None: the newest.
        thing: What is to be drawn, as "the cloud".
    """
    if not isinstance(error, TransformException):
        return fault_text(error)
    if not buffer.has_frame(frame):
        near = near_frame(frame, buffer.frame_names())
        return f"{thing} is in the frame {_quoted(frame)}, which nobody publishes{near}"
    if not buffer.has_frame(fixed_frame):
        near = near_frame(fixed_frame, buffer.frame_names())
        return (
            f"nobody publishes the fixed frame {_quoted(fixed_frame)}{near}, "
            f"and {thing} is in {_quoted(frame)}"
        )
    parents = buffer.parents()
    root, fixed_root = root_of(parents, frame), root_of(parents, fixed_frame)
    if root != fixed_root:
        return (
            f"{thing} is in the frame {_quoted(frame)}, which is not connected to the fixed frame "
            f"{_quoted(fixed_frame)}: the root of its tree is {_quoted(root)}, that of the other {_quoted(fixed_root)}"
        )
    if isinstance(error, ExtrapolationException):
        when = "the newest time that is known of the others on the way"
        if held_ns is not None:
            when = "the time that is shown"
        return _extrapolation_text(error, when, thing, frame, fixed_frame)
    return fault_text(error)


def _extrapolation_text(
    error: ExtrapolationException, when: str, thing: str, frame: str, fixed_frame: str
) -> str:
    gap = _gap_text(error)
    if not gap:
        return fault_text(error)
    way = f", on the way from {_quoted(frame)} to {_quoted(fixed_frame)}" if error.frame_id != frame else ""
    return f"{thing} can't be placed: the transforms of {_quoted(error.frame_id or frame)}{way} {gap} {when}"


def _gap_text(error: ExtrapolationException) -> str:
    """Return how far transforms are from the time that was asked for, as "end 2 s before"; empty if it is not known."""
    if error.gap_ns is None or error.requested_ns is None or error.oldest_ns is None:
        return ""
    gap = seconds_text(error.gap_ns / 1e9)
    return f"begin {gap} after" if error.requested_ns < error.oldest_ns else f"end {gap} before"


def lag_text(buffer: Buffer, fixed_frame: str, placed: Placed, thing: str) -> str:
    """Return why something is drawn where its frame was at another time than its stamp's; empty while that is usual.

    Transforms come a little later than the message that they belong to.

    Args:
        buffer: The transforms.
        fixed_frame: The fixed frame.
        placed: What is drawn, with its stamp.
        thing: What it is, as "the cloud".
    """
    frame = placed.frame_id.removeprefix("/") or fixed_frame
    try:
        buffer.lookup(fixed_frame, frame, placed.stamp_ns)
    except ExtrapolationException as error:
        gap = _gap_text(error)
        if not gap or (error.gap_ns or 0) <= PATIENCE_NS:
            return ""
        return (
            f"{thing} is drawn where its frame is at another time: the transforms of "
            f"{_quoted(error.frame_id or frame)} {gap} its stamp"
        )
    except TransformException:
        pass
    return ""


def message_text(error: Exception, label: str) -> str:
    """Return why a display of a kind can't draw a message, as one with a field that fits no other."""
    thing = "the robot" if label == "RobotModel" else thing_of(label)
    return f"{thing} can't be drawn: {fault_text(error)}"


def other_type_text(shown: str, sent: Iterable[str]) -> str:
    """Return that a topic's publishers send another type than the one that is shown."""
    names = ", ".join(shown_text(name, MAX_NAME) for name in sent)
    return (
        f"its publishers send {names}, and this display shows {shown}: switch it off and on to show the other"
    )


def qos_text(publishers: Sequence[EndpointInfo], requests: Sequence[QoS]) -> str:
    """Return which policy keeps all publishers from the requests of all subscriptions; empty if one is heard.

    Args:
        publishers: Those of the type that is shown.
        requests: What the subscriptions request.
    """
    reasons = []
    for publisher in publishers:
        apart = [differences(publisher.qos.resolved(), request.resolved()) for request in requests]
        if not all(apart):
            return ""
        if apart:
            name = "a publisher" if publisher.node is None else shown_text(publisher.node.full, MAX_NAME)
            reasons.append(f"{name}: {'; '.join(apart[0])}")
    return f"no message passes, because of its quality of service: {reasons[0]}" if reasons else ""
