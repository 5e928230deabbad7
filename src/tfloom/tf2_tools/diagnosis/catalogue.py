"""The kinds of findings: a stable code each, what it means, what causes it, and how to mend it.

docs/tf_doctor.md is written from this table by docs/tf_doctor.py.
"""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple


class Severity(Enum):
    """How much a finding matters."""

    ERROR = "error"
    """Lookups fail, or give wrong values."""
    WARNING = "warning"
    """Lookups may fail at times, or the finding may be on purpose."""


class Kind(NamedTuple):
    """A kind of findings."""

    code: str
    """`TF` and three digits, of which the first is the group."""
    severity: Severity
    title: str
    meaning: str
    """What tf2 does because of it."""
    cause: str
    mend: str
    """One sentence; findings print it."""


GROUPS = {
    "1": "The tree",
    "2": "Names",
    "3": "Values",
    "4": "Time",
    "5": "Topics and quality of service",
    "6": "Users of frames",
}
"""What the first digit of a code stands for."""

_ERROR, _WARNING = Severity.ERROR, Severity.WARNING

_KINDS = (
    Kind(
        "TF101",
        _ERROR,
        "several publishers of one frame",
        "Each listener stores what arrives last, so that the frame jumps between the publishers' values, or between "
        "their parents. tf2 gives no warning.",
        "Two nodes compute the same transform, as a localisation and a wheel odometry that both publish "
        "`odom -> base_link`; a node that runs twice; a static publisher beside robot_state_publisher.",
        "Run one of the publishers alone, or turn off the transform of the others (in many nodes a parameter "
        "`publish_tf`), or give each its own child frame.",
    ),
    Kind(
        "TF102",
        _ERROR,
        "an edge is both static and dynamic",
        "A listener keeps one history for a frame: the last message decides whether it is static, and replaces "
        "what was known. Lookups depend on the order of arrival.",
        "The frame is published on /tf_static and on /tf, often by a static publisher that was left in a launch file.",
        "Publish the frame on /tf_static if it never moves, else on /tf, and stop the other publisher.",
    ),
    Kind(
        "TF103",
        _ERROR,
        "a frame changes its parent back and forth",
        "A frame has one parent at a time. Lookups at a time between two parents fail as not connected, or as "
        "extrapolation.",
        "Two publishers with different parents, as map -> base_link and odom -> base_link, or one that sends both.",
        "Keep one parent for the frame; publish the other pose as a topic, or invert the second edge "
        "so that it hangs below the frame.",
    ),
    Kind(
        "TF104",
        _ERROR,
        "frames form a loop",
        "A lookup through the loop ends with the error that the tree is invalid because it contains a loop.",
        "Each of the edges is right by itself, but one of them has the wrong direction, or belongs to another frame.",
        "Remove one edge of the loop, or turn it round where it is published.",
    ),
    Kind(
        "TF105",
        _WARNING,
        "the frames are several trees",
        "Lookups from a frame of one tree to one of another fail as not connected.",
        "A publisher between the trees is missing or has not started; a frame's name is spelled in two ways; "
        "robots share a domain without a common root.",
        "Publish an edge between the roots, or correct the spelling of a frame; ignore this code if the trees are "
        "meant to be apart.",
    ),
    Kind(
        "TF106",
        _ERROR,
        "a frame is its own parent",
        "Listeners reject it: `TF_SELF_TRANSFORM: Ignoring transform … because they are the same`.",
        "A parameter for the parent or the child has the name of the other, or both have the same default.",
        "Correct the frame ids of the publisher.",
    ),
    Kind(
        "TF107",
        _ERROR,
        "a frame id is empty",
        "Listeners reject it: `TF_NO_CHILD_FRAME_ID` or `TF_NO_FRAME_ID`.",
        "`header.frame_id` or `child_frame_id` of the message was not set.",
        "Set both frame ids where the transform is built.",
    ),
    Kind(
        "TF108",
        _ERROR,
        "no transforms",
        "No frame is known: every lookup fails because a frame does not exist.",
        "No publisher runs, it is on another ROS_DOMAIN_ID or behind another discovery range, or it has published "
        "nothing while the doctor listened.",
        "Start a publisher; compare ROS_DOMAIN_ID and ROS_AUTOMATIC_DISCOVERY_RANGE of both sides (`tfloom doctor`); "
        "listen longer with `--seconds`.",
    ),
    Kind(
        "TF201",
        _WARNING,
        "a frame id begins with a slash",
        "tf2 stores the frame without the slash, and refuses lookups with one: `Invalid argument … frame_ids "
        "cannot start with a '/'`. So users of this name fail.",
        "A name from ROS 1's tf, or a prefix like `/robot1` joined to a frame's name.",
        "Write the frame id without the leading slash; inside a name a slash is allowed (`robot1/base_link`).",
    ),
    Kind(
        "TF202",
        _WARNING,
        "frames of REP 105 in another order",
        "REP 105 orders the frames earth, map, odom, base_link, each the parent of the next. Programs that expect it "
        "(navigation, localisation) look up or publish the wrong direction, and form loops or second parents.",
        "An edge is published upside down, or a frame of REP 105 hangs below one that REP 105 puts under it.",
        "Publish the transform from the outer frame (parent) to the inner one (child), inverting its value.",
    ),
    Kind(
        "TF203",
        _WARNING,
        "a frame of REP 105 is spelled in another way",
        "Programs look for the names of REP 105 to the letter: `map`, `odom`, `base_link`, `base_footprint`, `earth`.",
        "Capital letters, a hyphen, or a missing underscore in the publisher's parameters.",
        "Rename the frame to the spelling of REP 105.",
    ),
    Kind(
        "TF204",
        _WARNING,
        "transforms that the doctor does not check",
        "The doctor keeps at most 65,536 edges of 4,096 publishers, with names of at most 1,024 bytes; a transform "
        "beyond that is counted, but none of the other checks sees it. A buffer stores it.",
        "A frame id that is built in a loop or from data, so that it grows or is new each time.",
        "Give each frame a short name that stays the same.",
    ),
    Kind(
        "TF301",
        _ERROR,
        "a transform has numbers that are not finite",
        "Listeners reject a NaN: `TF_NAN_INPUT: Ignoring transform … because of a nan value`. They store infinities, "
        "which make each point that is transformed infinite or NaN.",
        "A division by zero, an uninitialised state of a filter, or a sensor without a measurement.",
        "Do not publish until the numbers are finite; find the division in the publisher.",
    ),
    Kind(
        "TF302",
        _ERROR,
        "a quaternion is not of unit length",
        "Listeners reject it if |q|² differs from 1 by 0.01 or more: `TF_DENORMALIZED_QUATERNION: Ignoring transform "
        "…`. Below, it stretches what it rotates.",
        "All four numbers 0 because the rotation was not set; w left out; Euler angles in the quaternion's fields; "
        "sums of rounding errors.",
        "Set w = 1 for no rotation, and divide the quaternion by its length before it is published.",
    ),
    Kind(
        "TF303",
        _WARNING,
        "a frame teleports",
        "Interpolation between the two poses passes through places where the frame has never been.",
        "Two publishers of one frame; a localisation that corrects itself, a restarted simulation; a rotation whose "
        "angle jumps by a turn in its computation.",
        "Find what the publisher does at that time; if the jump is meant, raise `--max-jump`, `--max-turn` or "
        "`--max-speed`.",
    ),
    Kind(
        "TF401",
        _ERROR,
        "transforms on /tf are stamped zero",
        "The frame is known at time zero alone: lookups at the time of a sensor's data fail as extrapolation into "
        "the future, and a lookup of the latest time takes the other edges at time zero.",
        "`header.stamp` was not set, or the node uses simulated time and has received no /clock.",
        "Set `header.stamp` to the time of the measurement; start what publishes /clock.",
    ),
    Kind(
        "TF402",
        _WARNING,
        "stamps are ahead of now",
        "Lookups of the latest time give a pose that was predicted; a stamp far ahead hides all later transforms of "
        "its frame, which then are too old.",
        "A clock that is ahead; seconds and nanoseconds mixed up; a localisation that stamps its transform ahead on "
        "purpose (`transform_tolerance` of AMCL).",
        "Synchronise the clocks and stamp with the time of the measurement; ignore this code, or raise `--max-ahead`, "
        "where it is meant.",
    ),
    Kind(
        "TF403",
        _WARNING,
        "a publisher's clock differs",
        "All its stamps are off by the same time, so that lookups with data of other hosts fail as extrapolation, or "
        "give poses of another time.",
        "The host's clock is not synchronised; a node mixes simulated and system time; a constant is added to the "
        "stamps (`transform_tolerance` of AMCL).",
        "Synchronise the clocks (chrony or PTP), and set `use_sim_time` alike on all nodes.",
    ),
    Kind(
        "TF404",
        _WARNING,
        "a frame is published rarely",
        "Lookups at the time of data wait for the next transform, or fail as extrapolation into the future.",
        "A timer with a long period, an overloaded node, or a lossy link.",
        "Publish more often than the data that needs the frame, or raise the timeout of the lookup above the period.",
    ),
    Kind(
        "TF405",
        _WARNING,
        "a frame's period varies",
        "Timeouts that fit the mean period expire at times, and interpolation spans unequal distances.",
        "An overloaded host or executor, callbacks that block the timer, or a lossy link.",
        "Move slow work out of the publisher's callbacks; stamp with the time of the measurement.",
    ),
    Kind(
        "TF406",
        _WARNING,
        "a frame was not published for a while",
        "Lookups in the gap interpolate across it, or fail until the next transform comes.",
        "The publisher stopped, crashed or was blocked, or its messages were lost.",
        "Look at the publisher's log at that time; check its load and the network.",
    ),
    Kind(
        "TF407",
        _ERROR,
        "transforms are rejected as old",
        "Listeners drop a transform that is older than their newest of that frame by more than their history (10 s): "
        "`TF_OLD_DATA ignoring data from the past for frame …`.",
        "Another publisher, or one message, whose stamps are ahead; a publisher that sends old data; "
        "a recording that is played beside the live robot.",
        "Find the publisher whose stamps differ from the others', and stop it or correct its clock.",
    ),
    Kind(
        "TF408",
        _ERROR,
        "time jumped back",
        "The publisher's stamps went back and continued from there. Listeners that keep the transforms of the former "
        "time reject the new ones (TF_OLD_DATA) until these have caught up.",
        "A simulation was restarted, or a recording repeats (`--loop`), while listeners without `use_sim_time`, or "
        "without /clock, keep on running.",
        "Set `use_sim_time` on the listeners, whose buffers then are cleared by the jump of /clock, or restart them.",
    ),
    Kind(
        "TF501",
        _WARNING,
        "/tf carries transforms that never change",
        "Each repetition costs network and time, and lookups fail where the next one is late, which cannot happen on "
        "/tf_static.",
        "A fixed mounting that is published by a timer, or a robot that stood still while the doctor listened.",
        "Publish fixed transforms once by a StaticTransformBroadcaster; ignore this code while the robot stands "
        "still.",
    ),
    Kind(
        "TF502",
        _ERROR,
        "/tf_static carries transforms that change",
        "A static frame has one value for all times: each change moves it in the past as well, so that data of "
        "before is transformed wrongly.",
        "A StaticTransformBroadcaster that is called in a timer or a callback.",
        "Publish what moves on /tf, by a TransformBroadcaster.",
    ),
    Kind(
        "TF503",
        _ERROR,
        "quality of service that does not match",
        "The publisher and the subscription do not connect: no transform arrives, and tf2 gives no error but that "
        "frames do not exist.",
        "A publisher of /tf_static that is volatile, or one of /tf or /tf_static that is best effort, while "
        "listeners request transient local on /tf_static, and reliable on both.",
        "Use TransformBroadcaster and StaticTransformBroadcaster, or their profiles: /tf reliable and volatile, "
        "/tf_static reliable and transient local.",
    ),
    Kind(
        "TF504",
        _WARNING,
        "an unusual quality of service",
        "A volatile subscription to /tf_static misses all that was published before it. "
        "A volatile or best effort publisher reaches no listener with tf2's own profile.",
        "A publisher or a subscription that was written by hand, or by `topic pub` and `topic echo` with flags.",
        "Request and offer tf2's profiles: /tf reliable and volatile, /tf_static reliable and transient local.",
    ),
    Kind(
        "TF505",
        _ERROR,
        "messages that cannot be read",
        "Listeners drop the whole message.",
        "A publisher with another definition of the type, or one that fills the bytes by itself.",
        "Build the publisher with the definitions of this ROS 2 release.",
    ),
    Kind(
        "TF506",
        _ERROR,
        "/tf or /tf_static with another type",
        "It connects with no listener.",
        "A topic of this name is used for something else, or with a type of ROS 1.",
        "Publish tf2_msgs/msg/TFMessage there, or rename the topic.",
    ),
    Kind(
        "TF601",
        _ERROR,
        "data in a frame that no transform holds",
        "A program that transforms the data gets: `… passed to lookupTransform argument source_frame does not exist`.",
        "A frame's name in the driver's parameters that is not in the robot's description, or a missing static "
        "transform of the sensor.",
        "Set the driver's frame id to one of the tree's, or publish the sensor's mounting on /tf_static.",
    ),
    Kind(
        "TF602",
        _ERROR,
        "lookups of a frame that no transform holds",
        "The buffer server answers the request with an error.",
        "A misspelled frame in the client, or a publisher that is not running.",
        "Correct the frame in the client's request, or start its publisher.",
    ),
)

KINDS = {kind.code: kind for kind in _KINDS}
"""All kinds, by their codes, in order."""


class Limits(NamedTuple):
    """What the checks take for sound."""

    min_rate_hz: float = 5.0
    max_gap_s: float = 0.5
    """A longer time without a transform is a gap, if it is `GAP_PERIODS` mean periods as well."""
    max_jitter: float = 0.4
    """Standard deviation of the period, in means of it, without the longest one."""
    max_ahead_s: float = 0.1
    max_skew_s: float = 0.2
    max_jump_m: float = 1.0
    """A longer step from one transform to the next is a teleport, if it is faster than `max_speed_m_s` and sudden."""
    max_speed_m_s: float = 10.0
    max_turn_deg: float = 60.0
    """A wider turn from one transform to the next is a teleport, if it is faster than `MAX_SPIN_DEG_S` and sudden."""
    max_norm_error: float = 1e-3
    """Of a quaternion: | |q| - 1 |."""


GAP_PERIODS = 5.0
"""A gap is at least as long as this number of mean periods."""
MIN_JITTER_S = 0.02
"""A standard deviation of the period below this is not jitter, because a host's scheduling causes it."""
MAX_SPIN_DEG_S = 180.0
MIN_COUNT = 8
"""The number of transforms from which a statistic says something."""
