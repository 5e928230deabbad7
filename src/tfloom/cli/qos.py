"""The flags that state a quality of service, and the quality that suits a topic's publishers."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from typing import Any

from tfloom.cli.errors import CommandError
from tfloom.cli.numbers import count, seconds
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoS, ReliabilityPolicy

PROFILES = (
    "unknown",
    "default",
    "system_default",
    "sensor_data",
    "services_default",
    "parameters",
    "parameter_events",
    "action_status_default",
    "best_available",
)
POLICIES = {
    "history": ("system_default", "keep_last", "keep_all", "unknown"),
    "reliability": ("system_default", "reliable", "best_effort", "unknown", "best_available"),
    "durability": ("system_default", "transient_local", "volatile", "unknown", "best_available"),
    "liveliness": ("system_default", "automatic", "manual_by_topic", "unknown", "best_available"),
}
KINDS = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}


def add_arguments(parser: argparse.ArgumentParser, default: str) -> None:
    """Add the QoS flags; `default` says in the help what happens without them."""
    parser.add_argument(
        "--qos-profile", choices=PROFILES, help=f"start from this profile (default: {default})"
    )
    parser.add_argument("--qos-depth", metavar="N", type=count, help="how many messages to keep")
    for policy, choices in POLICIES.items():
        parser.add_argument(f"--qos-{policy}", choices=choices, help=f"{policy} policy")
    parser.add_argument(
        "--qos-liveliness-lease-duration-seconds",
        type=seconds,
        help="how long a publisher may be silent in seconds",
    )


def asked_qos(args: argparse.Namespace, base: QoS) -> QoS | None:
    """Return the quality that the flags ask for, over that of --qos-profile or else `base`; None without a flag.

    Raises:
        CommandError: what they ask for can't be had.
    """
    qos = base if args.qos_profile is None else _profile(args.qos_profile)
    asked = {policy: getattr(args, f"qos_{policy}") for policy in POLICIES if getattr(args, f"qos_{policy}")}
    if "unknown" in asked.values():
        raise CommandError("'unknown' is what a policy of others can be, not one to ask for")
    changes: dict[str, Any] = {policy: KINDS[policy][choice.upper()] for policy, choice in asked.items()}
    if args.qos_depth is not None:
        changes["depth"] = args.qos_depth
    if (lease_s := args.qos_liveliness_lease_duration_seconds) is not None:
        changes["liveliness_lease_ns"] = round(lease_s * 1e9)
    if args.qos_profile is None and not changes:
        return None
    return qos._replace(**changes)


def _profile(name: str) -> QoS:
    from tfloom.node.qos.qos import InvalidQoSProfileException, QoSPresetProfiles

    try:
        qos: QoS = QoSPresetProfiles.get_from_short_key(name).to_wire()
    except InvalidQoSProfileException as error:
        raise CommandError(f"--qos-profile {name} can't be used: {error}") from None
    return qos


def suiting_qos(publishers: Sequence[EndpointInfo]) -> QoS:
    """Return the strictest quality that connects to all of these publishers."""
    return QoS(
        reliability=(
            ReliabilityPolicy.RELIABLE
            if _all_offer(publishers, "reliability", ReliabilityPolicy.RELIABLE)
            else ReliabilityPolicy.BEST_EFFORT
        ),
        durability=(
            DurabilityPolicy.TRANSIENT_LOCAL
            if _all_offer(publishers, "durability", DurabilityPolicy.TRANSIENT_LOCAL)
            else DurabilityPolicy.VOLATILE
        ),
        # What many publishers kept for late comers arrives at once.
        history=HistoryPolicy.KEEP_ALL,
    )


def _all_offer(publishers: Sequence[EndpointInfo], policy: str, strict: object) -> bool:
    offers = [getattr(publisher.qos, policy) == strict for publisher in publishers]
    if any(offers) and not all(offers):
        print(
            f"{sum(offers)} of {len(offers)} publishers of {publishers[0].topic.name} offer "
            f"{getattr(strict, 'name', strict)}; listening without it, to hear all of them",
            file=sys.stderr,
        )
    return bool(offers) and all(offers)
