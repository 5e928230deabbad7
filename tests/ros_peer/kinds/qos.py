"""Quality of service: which publisher and subscription match, what passes between them, and which events come.

Every pair of an offer and a request is a case.
"""

from __future__ import annotations

import itertools
import time
from typing import Any

WIRE = "rmw_cyclonedds_cpp"

MATCH_S = 10.0
"""The longest wait for a match, or for the events of a mismatch [s]."""
SETTLE_S = 0.02
"""How long nothing else may come afterwards [s]."""

POLICIES: dict[str, list[Any]] = {
    "reliability": ["RELIABLE", "BEST_EFFORT"],
    "durability": ["TRANSIENT_LOCAL", "VOLATILE"],
    "deadline": [None, 10.0],
    "liveliness": ["AUTOMATIC", "MANUAL_BY_TOPIC"],
    "lease": [None, 20.0],
}
PROFILES = [dict(zip(POLICIES, values, strict=True)) for values in itertools.product(*POLICIES.values())]
DEFAULTS = [
    {
        "reliability": reliability,
        "durability": durability,
        "deadline": None,
        "liveliness": liveliness,
        "lease": None,
    }
    for reliability, durability, liveliness in itertools.product(
        ["SYSTEM_DEFAULT", "RELIABLE", "BEST_EFFORT"],
        ["SYSTEM_DEFAULT", "TRANSIENT_LOCAL", "VOLATILE"],
        ["SYSTEM_DEFAULT"],
    )
]
EVERY = [
    {"offered": offered, "requested": requested}
    for profiles in (PROFILES, DEFAULTS)
    for offered, requested in itertools.product(profiles, profiles)
]


class Ends:
    """Two nodes of this process, and the executor that spins them."""

    def __init__(self) -> None:
        import rclpy
        from rclpy.executors import SingleThreadedExecutor

        rclpy.init()
        self.nodes = [rclpy.create_node(name) for name in ("offers", "requests")]
        self.executor = SingleThreadedExecutor()
        for node in self.nodes:
            self.executor.add_node(node)
        self.numbers = itertools.count()


ends: list[Ends] = []


def profile(case: dict[str, Any]) -> Any:
    from rclpy.duration import Duration
    from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

    durations = {
        name: Duration(seconds=case[key])
        for name, key in (("deadline", "deadline"), ("liveliness_lease_duration", "lease"))
        if case[key] is not None
    }
    return QoSProfile(
        depth=5,
        reliability=ReliabilityPolicy[case["reliability"]],
        durability=DurabilityPolicy[case["durability"]],
        liveliness=LivelinessPolicy[case["liveliness"]],
        **durations,
    )


def mismatches(case: Any) -> list[str]:
    """Return the policies of which the offer is less than the request."""
    offered, requested = case["offered"], case["requested"]
    orders = {
        "reliability": ["RELIABLE", "BEST_EFFORT"],
        "durability": ["TRANSIENT_LOCAL", "VOLATILE"],
        "liveliness": ["MANUAL_BY_TOPIC", "AUTOMATIC"],
    }
    names = [
        name
        for name, order in orders.items()
        if offered[name] in order
        and requested[name] in order
        and order.index(offered[name]) > order.index(requested[name])
    ]
    return names + [
        name
        for name in ("deadline", "lease")
        if requested[name] is not None and (offered[name] is None or offered[name] > requested[name])
    ]


def run(case: Any) -> Any:
    """Return the counts, the events and the messages of both ends of a topic."""
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
    from rclpy.qos import qos_check_compatible
    from std_msgs.msg import Int32

    if not ends:
        ends.append(Ends())
    (both,) = ends
    topic = f"topic{next(both.numbers)}"
    events: dict[str, list[Any]] = {"offer": [], "request": [], "offer matched": [], "request matched": []}
    heard: list[int] = []
    offered, requested = profile(case["offered"]), profile(case["requested"])
    subscription = both.nodes[1].create_subscription(
        Int32,
        topic,
        lambda msg: heard.append(msg.data),
        requested,
        event_callbacks=SubscriptionEventCallbacks(
            incompatible_qos=events["request"].append, matched=events["request matched"].append
        ),
    )
    publisher = both.nodes[0].create_publisher(
        Int32,
        topic,
        offered,
        event_callbacks=PublisherEventCallbacks(
            incompatible_qos=events["offer"].append, matched=events["offer matched"].append
        ),
    )

    def spin_until(is_met: Any, seconds: float) -> None:
        end_s = time.monotonic() + seconds
        while time.monotonic() < end_s and not is_met():
            both.executor.spin_once(timeout_sec=0.005)

    spin_until(
        lambda: (
            (events["offer"] and events["request"]) or (events["offer matched"] and events["request matched"])
        ),
        MATCH_S,
    )
    counts = [publisher.get_subscription_count(), subscription.get_publisher_count()]
    publisher.publish(Int32(data=7))
    if all(counts):
        spin_until(lambda: heard, MATCH_S)
    spin_until(lambda: False, SETTLE_S)
    is_single = len(mismatches(case)) == 1  # of several, each implementation names another one
    answer = {
        "counts": counts,
        "heard": heard,
        **{
            end: [
                [
                    event.total_count,
                    event.total_count_change,
                    int(event.last_policy_kind) if is_single else None,
                ]
                for event in events[end]
            ]
            for end in ("offer", "request")
        },
        **{
            end: [[event.total_count, event.current_count] for event in events[end]]
            for end in ("offer matched", "request matched")
        },
        "checked": qos_check_compatible(offered, requested)[0].name,
        "infos": [
            [
                info.qos_profile.reliability.name,
                info.qos_profile.durability.name,
                info.qos_profile.liveliness.name,
            ]
            for info in (
                both.nodes[1].get_publishers_info_by_topic(topic)[:1]
                + both.nodes[0].get_subscriptions_info_by_topic(topic)[:1]
            )
        ],
    }
    both.nodes[0].destroy_publisher(publisher)
    both.nodes[1].destroy_subscription(subscription)
    return answer


def is_left_to_the_wire(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether a policy is SYSTEM_DEFAULT, for which Cyclone and Fast DDS choose differently."""
    ends_of_case = (case["offered"], case["requested"])
    return theirs["checked"] == ours["checked"] and any(
        end[policy] == "SYSTEM_DEFAULT" for end in ends_of_case for policy in ("reliability", "durability")
    )


KNOWN = {"qos-system-default": is_left_to_the_wire}
