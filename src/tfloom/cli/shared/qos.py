"""The flags for a quality of service, and the quality that is compatible with a topic's publishers."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import count, seconds
from tfloom.common.terminal import report
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.compatibility import best_available
from tfloom.rmw.qos import (
    POLICIES,
    PROFILES,
    DurabilityPolicy,
    HistoryPolicy,
    QoS,
    QoSPolicyEnum,
    ReliabilityPolicy,
    unknown_policies,
)


def add_arguments(parser: argparse.ArgumentParser, default: str) -> None:
    """Add the QoS flags; `default` describes, for the help text, the quality without them."""
    parser.add_argument(
        "--qos-profile", choices=list(PROFILES), help=f"start from this profile (default: {default})"
    )
    parser.add_argument("--qos-depth", metavar="N", type=count, help="number of messages to keep")
    for policy, kind in POLICIES.items():
        parser.add_argument(f"--qos-{policy}", choices=kind.short_keys(), help=f"{policy} policy")
    parser.add_argument(
        "--qos-liveliness-lease-duration-seconds",
        type=seconds,
        help="longest time without an assertion of liveliness in seconds",
    )


def requested_qos(args: argparse.Namespace, base: QoS) -> QoS | None:
    """Return the quality of the flags, with the rest from --qos-profile or else `base`; None without a flag.

    Raises:
        CommandError: they request an UNKNOWN policy.
    """
    qos = base if args.qos_profile is None else _profile(args.qos_profile)
    asked = {policy: getattr(args, f"qos_{policy}") for policy in POLICIES if getattr(args, f"qos_{policy}")}
    if "unknown" in asked.values():
        raise CommandError("'unknown' is a policy that peers can have, but that can't be requested")
    changes: dict[str, Any] = {
        policy: POLICIES[policy].get_from_short_key(choice) for policy, choice in asked.items()
    }
    if args.qos_depth is not None:
        changes["depth"] = args.qos_depth
    if (lease_s := args.qos_liveliness_lease_duration_seconds) is not None:
        changes["liveliness_lease_ns"] = round(lease_s * 1e9)
    if args.qos_profile is None and not changes:
        return None
    return qos._replace(**changes)


def _profile(name: str) -> QoS:
    qos = PROFILES[name]
    if unknown := unknown_policies(qos):
        raise CommandError(f"--qos-profile {name} can't be used: {unknown[0]} is UNKNOWN")
    return qos.resolved(default_depth=0)


def suiting_qos(publishers: Sequence[EndpointInfo]) -> QoS:
    """Return the strictest quality that connects to all of these publishers; without any, the least strict."""
    # KEEP_ALL, because the samples that many publishers kept for late readers arrive at once.
    if not publishers:
        return QoS(ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE, history=HistoryPolicy.KEEP_ALL)
    best = QoS(
        ReliabilityPolicy.BEST_AVAILABLE, DurabilityPolicy.BEST_AVAILABLE, history=HistoryPolicy.KEEP_ALL
    )
    _warn_of_split(publishers, "reliability", ReliabilityPolicy.RELIABLE)
    _warn_of_split(publishers, "durability", DurabilityPolicy.TRANSIENT_LOCAL)
    return best_available(best, [publisher.qos for publisher in publishers], is_writer=False)


def _warn_of_split(publishers: Sequence[EndpointInfo], policy: str, strict: QoSPolicyEnum) -> None:
    """Print a line on stderr where some of the publishers offer a policy and some don't."""
    offers = [getattr(publisher.qos, policy) == strict for publisher in publishers]
    if any(offers) and not all(offers):
        report(
            f"{sum(offers)} of {len(offers)} publishers of {publishers[0].topic.name} offer "
            f"{strict.name}; subscribing without it, to receive from all of them"
        )
