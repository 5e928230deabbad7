"""The checks of `doctor`. Each returns its finding on one subject; none raises."""

from __future__ import annotations

import os
import platform
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from importlib.machinery import PathFinder
from pathlib import Path
from typing import Any, NamedTuple

import tfloom
from tfloom.cli.doctor.finding import Finding, Verdict
from tfloom.cli.doctor.peers import SharedDomain, check_peers, check_qos, check_services
from tfloom.cli.doctor.wires import check_other_wire
from tfloom.cli.doctor.zenoh import WIRE, check_router, check_zenoh_reach, is_zenoh_selected
from tfloom.common.terminal import shown_part
from tfloom.rmw.errors import WireError
from tfloom.ros_imports import ros_distro
from tfloom.workspace import index

DISCOVERY_SERVER = "ROS_DISCOVERY_SERVER"
"""Names discovery servers of Fast DDS; stock nodes with it announce themselves to these alone."""

TRIP_TIMEOUT_S = 5.0
LARGE_BUFFER = 4 << 20
"""Receive buffer that suffices for messages of megabytes at best effort [bytes]."""

DISTRIBUTIONS = (
    "tfloom-ros2",
    "tfloom-rviz",
    "tfloom-interfaces",
    "tfloom-sensing",
    "tfloom-ddsc",
    "cyclonedds",
    "numpy",
    "PyYAML",
    "argcomplete",
    "reportlab",
    "pygame-ce",
    "Pillow",
    "colcon-core",
)


def check_wire() -> Finding:
    """Check the wire of RMW_IMPLEMENTATION, and its library."""
    from tfloom.rmw.backends import DEFAULT, implementation_identifier

    asked = os.environ.get("RMW_IMPLEMENTATION")
    details: dict[str, Any] = {"RMW_IMPLEMENTATION": asked or "not set"}
    library_text, passed_over = "", ""
    try:
        name = implementation_identifier()
        if name == DEFAULT:
            from tfloom.rmw.cyclone.library import open_library

            library = open_library()
            details["library"], details["library version"] = library.path, library.version or "unknown"
            details["library from"] = library.origin
            details.update({f"passed over {n}": text for n, text in enumerate(library.passed_over, 1)})
            library_text = f"; libddsc {library.version or 'of unknown version'} of {library.origin}"
            passed_over = "; ".join(library.passed_over)
        elif name == WIRE:
            from importlib.metadata import version

            from tfloom.rmw.zenoh.library import open_library as open_zenoh

            open_zenoh()
            details["library version"] = version("eclipse-zenoh")
            library_text = f"; eclipse-zenoh {details['library version']}"
    except WireError as error:
        return Finding(Verdict.FAILED, str(error), details=details)
    why = (
        "selected by RMW_IMPLEMENTATION"
        if asked == name
        else f"in place of {asked}"
        if asked
        else "the default"
    )
    verdict = Verdict.WARNING if passed_over else Verdict.OK
    return Finding(verdict, f"{name}, {why}{library_text}", passed_over, details)


def check_domain() -> Finding:
    """Check ROS_DOMAIN_ID and the discovery range."""
    from tfloom.rmw.backends import domain_id_from_environment
    from tfloom.rmw.cyclone.config import (
        configuration,
        discovery_range,
        look_up_peers,
        why_peers_are_ignored,
    )

    names = (
        "ROS_DOMAIN_ID",
        "ROS_AUTOMATIC_DISCOVERY_RANGE",
        "ROS_LOCALHOST_ONLY",
        "ROS_STATIC_PEERS",
        DISCOVERY_SERVER,
        "TFLOOM_LEASE_S",
        "CYCLONEDDS_URI",
    )
    details = {name: os.environ.get(name, "not set") for name in names}
    try:
        domain = domain_id_from_environment()
        configuration(domain)
        look_up_peers()
        ignored = why_peers_are_ignored()
    except WireError as error:
        return Finding(Verdict.FAILED, str(error), details=details)
    if os.environ.get(DISCOVERY_SERVER):
        summary = (
            f"domain {domain}; {DISCOVERY_SERVER} has no effect: tfloom uses no discovery server of Fast DDS"
        )
        advice = (
            f"stock nodes that have it set, and tfloom's, don't find each other: unset {DISCOVERY_SERVER} for both, "
            "and name hosts beyond the subnet in ROS_STATIC_PEERS"
        )
        return Finding(Verdict.WARNING, summary, advice, details)
    if ignored:
        advice = "it has an effect with the discovery range LOCALHOST or SUBNET, without the other settings"
        return Finding(
            Verdict.WARNING,
            f"domain {domain}; ROS_STATIC_PEERS is ignored, because {ignored}",
            advice,
            details,
        )
    if os.environ.get("CYCLONEDDS_URI"):
        return Finding(
            Verdict.OK, f"domain {domain}, discovery as configured by CYCLONEDDS_URI", details=details
        )
    # Only now the range: it has no effect where CYCLONEDDS_URI configures discovery.
    summary, advice = _about_range(domain, discovery_range())
    return Finding(Verdict.OK, summary, advice, details)


def _about_range(domain: int, asked: str) -> tuple[str, str]:
    """Return what a discovery range means, and what to do where a stock ROS is not discovered."""
    if asked == "OFF":
        advice = (
            "discovery is off, on this machine too: export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST or SUBNET"
        )
        return f"domain {domain}, discovery range OFF", advice
    advice = (
        "a stock ROS is discovered only with the same range on both sides: "
        f"export ROS_AUTOMATIC_DISCOVERY_RANGE={'SUBNET' if asked == 'LOCALHOST' else asked} "
        f"on both{' (its default is SUBNET)' if asked == 'LOCALHOST' else ''}"
    )
    if is_zenoh_selected():  # where others need not have the same range
        advice = ""
    return f"domain {domain}, discovery range {asked}", advice


def check_network() -> Finding:
    """Check the network interfaces, multicast on them, and the receive buffer of sockets."""
    interfaces = list(_interfaces())
    details: dict[str, Any] = {interface.name: interface.state for interface in interfaces}
    up = [f"{interface.name} ({interface.multicast})" for interface in interfaces if interface.is_up]
    summary = (
        f"interfaces that are up: {', '.join(up) or 'not known on this system'}{_used_interface(interfaces)}"
    )
    if interfaces and _needs_multicast() and not any(interface.may_find_others for interface in interfaces):
        advice = "ROS_STATIC_PEERS can name hosts to search without multicast"
        return Finding(
            Verdict.WARNING, f"{summary}; none can discover other machines by multicast", advice, details
        )
    limit = Path("/proc/sys/net/core/rmem_max")
    if limit.is_file():
        details["net.core.rmem_max"] = int(limit.read_text())
        if details["net.core.rmem_max"] < LARGE_BUFFER:
            advice = (
                f"for messages of megabytes at best effort: sudo sysctl -w net.core.rmem_max={LARGE_BUFFER}"
            )
            summary += f"; a socket holds {details['net.core.rmem_max']} bytes at most"
            return Finding(Verdict.WARNING, summary, advice, details)
    return Finding(Verdict.OK, summary, details=details)


def _requested_range() -> str:
    """Return the discovery range; empty where it is invalid, which another check reports, or has no effect."""
    from tfloom.rmw.backends import DEFAULT, implementation_identifier
    from tfloom.rmw.cyclone.config import discovery_range

    try:
        ruled = not os.environ.get("CYCLONEDDS_URI") and implementation_identifier() == DEFAULT
        return discovery_range() if ruled else ""
    except WireError:
        return ""


def _needs_multicast() -> bool:
    return _requested_range() == "SUBNET" and not os.environ.get("ROS_STATIC_PEERS")


def _used_interface(interfaces: list[Interface]) -> str:
    """Return a text with the interface that the wire uses; empty if it is unknown."""
    from tfloom.rmw.cyclone.config import why_peers_are_ignored

    if _requested_range() == "OFF":
        return "; DDS uses none"
    if _requested_range() == "LOCALHOST":
        loopback = next(
            (interface.name for interface in interfaces if interface.is_loopback), "the loopback interface"
        )
        reaches_peers = os.environ.get("ROS_STATIC_PEERS") and not why_peers_are_ignored()
        beside = " and those towards ROS_STATIC_PEERS" if reaches_peers else ""
        return f"; DDS uses {loopback}{beside}, by unicast"
    far = [interface.name for interface in interfaces if interface.may_find_others]
    return f"; DDS uses {far[0]}, by multicast" if _requested_range() == "SUBNET" and len(far) == 1 else ""


class Interface(NamedTuple):
    """A network interface and its flags (IFF_UP and others of linux/if.h)."""

    name: str
    flags: int

    @property
    def is_up(self) -> bool:
        """Whether the interface is up."""
        return bool(self.flags & 0x1)

    @property
    def is_loopback(self) -> bool:
        """Whether it is a loopback interface."""
        return bool(self.flags & 0x8)

    @property
    def multicast(self) -> str:
        """The state of multicast there, in words."""
        return "multicast" if self.flags & 0x1000 else "no multicast"

    @property
    def state(self) -> str:
        """Its description for `--report`."""
        return f"{'up' if self.is_up else 'down'}, {self.multicast}"

    @property
    def may_find_others(self) -> bool:
        """Whether multicast can discover other machines there."""
        return self.is_up and not self.is_loopback and self.multicast == "multicast"


def _interfaces() -> Iterator[Interface]:
    """Yield each interface, on Linux."""
    for folder in sorted(Path("/sys/class/net").glob("*")):
        try:
            flags = int((folder / "flags").read_text(), 16)
        except (OSError, ValueError):
            continue
        yield Interface(folder.name, flags)


def check_reach() -> Finding:
    """Check from where the sockets of the wire can be reached, and whether that is protected."""
    from tfloom.rmw.backends import DEFAULT, domain_id_from_environment, implementation_identifier
    from tfloom.rmw.cyclone.config import is_security_requested

    details = {"ROS_SECURITY_ENABLE": os.environ.get("ROS_SECURITY_ENABLE", "not set")}
    try:
        if (name := implementation_identifier()) == WIRE:
            return check_zenoh_reach(details)
        if name != DEFAULT:
            return Finding(Verdict.OK, f"{name} stays inside one process", details=details)
        domain = domain_id_from_environment()
        opened = _opened_ports(domain) or _unbound_ports(domain)
    except WireError as error:
        return Finding(Verdict.FAILED, str(error), details=details)
    advice = "protect the network by a firewall, or by a VPN such as WireGuard: see docs/security.md"
    if opened:
        risk = "any machine that reaches them can read and publish all topics and call all services"
        return Finding(
            Verdict.WARNING, f"{opened}, on all interfaces: {risk}, without encryption", advice, details
        )
    where = "no socket is open" if _requested_range() == "OFF" else "the sockets are bound to loopback"
    if is_security_requested():
        summary = f"{where}, but ROS_SECURITY_ENABLE has no effect: nothing is encrypted"
        return Finding(Verdict.WARNING, summary, advice, details)
    return Finding(Verdict.OK, f"within this machine: {where}", details=details)


def _opened_ports(domain: int) -> str:
    """Return a text with what the environment opens to other machines; empty if nothing.

    Raises:
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't one of the ranges.
    """
    from tfloom.rmw.cyclone.config import discovery_range, is_local

    if os.environ.get("CYCLONEDDS_URI"):
        return "CYCLONEDDS_URI opens the UDP ports of its configuration"
    asked = discovery_range()
    if asked == "OFF" or is_local():
        return ""
    if asked == "LOCALHOST":
        return f"ROS_STATIC_PEERS opens {_port_pair(domain)}"
    multicast = f"{_first_port(domain)} and {_first_port(domain) + 1}"
    if asked == "SUBNET":
        return f"discovery range {asked} opens the UDP ports {multicast} and {_port_pair(domain)}"
    return f"discovery range {asked} opens the UDP ports {multicast} and one that the system selects"


def _unbound_ports(domain: int) -> str:
    """Return a text with what is open although the environment confines it to this machine; empty if nothing.

    Raises:
        WireError: the domain can't be joined.
    """
    from tfloom.rmw.cyclone.wire import CycloneParticipant

    participant = CycloneParticipant(domain, "/")
    failure = participant.loopback_failure
    participant.close()
    return f"{_port_pair(domain)} aren't bound to loopback, because {failure}" if failure else ""


def _first_port(domain: int) -> int:
    """Return the first port of a domain, by RTPS's formula."""
    return 7400 + 250 * domain


def _port_pair(domain: int) -> str:
    return f"two UDP ports from {_first_port(domain) + 10} on"


def check_round_trip() -> Finding:
    """Check that two participants of this process discover each other on the domain and exchange a message."""
    from tfloom.interfaces.std_msgs.msg import Empty
    from tfloom.rmw.backends import open_participant
    from tfloom.rmw.base import NodeName
    from tfloom.rmw.qos import QoS
    from tfloom.rmw.typed_names import topic_of

    node, topic = NodeName("/", "_tfloom_doctor"), topic_of(Empty, "/_tfloom_doctor")
    start = time.monotonic()
    try:
        here, there = open_participant(), open_participant()
    except WireError as error:
        return Finding(Verdict.FAILED, str(error))
    try:
        writer = here.create_writer(node, topic, QoS())
        reader = there.create_reader(node, topic, QoS())
        # Wait for both sides: a volatile writer sends nothing to a reader that it doesn't know yet, and a reader drops
        # what comes from a writer that it doesn't know.
        while not (writer.matched_count() and reader.matched_count()):
            if time.monotonic() - start > TRIP_TIMEOUT_S:
                return Finding(
                    Verdict.FAILED,
                    f"two participants did not discover each other within {TRIP_TIMEOUT_S:g} s",
                    "see the row of the router"
                    if is_zenoh_selected()
                    else "a firewall may block UDP on this interface, or the domain may be full",
                )
            time.sleep(0.002)
        found_s = time.monotonic() - start
        # An empty message in CDR: four bytes of header (little endian), and one byte, padded, for a struct without
        # fields.
        writer.write(bytes((0, 1, 0, 0, 0, 0, 0, 0)))
        while reader.take() is None:
            if time.monotonic() - start > 2 * TRIP_TIMEOUT_S:
                return Finding(
                    Verdict.FAILED, "two participants discovered each other, but a message was lost"
                )
            time.sleep(0.0005)
    finally:
        here.close()
        there.close()
    return Finding(
        Verdict.OK,
        f"two participants discovered each other in {found_s * 1e3:.0f} ms and exchanged a message",
    )


def check_names() -> Finding:
    """Check from which distribution a Python program imports each of ROS's names."""
    ours, others = {}, {}
    for name, prefix in index.own_packages().items():
        folder = prefix / "ros_names" / name
        if not folder.is_dir():
            continue  # programs alone
        spec = PathFinder.find_spec(name)
        origin = str(spec.origin) if spec is not None else ""
        if Path(origin).parent == folder:
            ours[name] = "tfloom"
        else:
            others[name] = origin or "nobody"
    details = {**ours, **others}
    if not others:
        return Finding(Verdict.OK, f"all {len(ours)} packages come from tfloom", details=details)
    # Others provide some names. If nobody provides any of them, tfloom.pth was not read; if none is ours, a sourced ROS
    # comes first on the path, which works. A mixture is a failure if rclpy is among theirs; otherwise it may be on
    # purpose, as a workspace's own ros2cli.
    nobody = all(origin == "nobody" for origin in others.values())
    if nobody:
        advice = (
            "call tfloom.use_ros_names() first, or reinstall tfloom into this environment's site-packages"
        )
        return Finding(Verdict.FAILED, "programs can't import rclpy: tfloom.pth wasn't read", advice, details)
    if not ours:
        return Finding(
            Verdict.WARNING,
            "all names come from a real ROS, which takes precedence over tfloom",
            details=details,
        )
    shadows = _shadowing_distributions(others)
    if shadows:
        named = ", ".join(f"{name} is that of the distribution {other}" for name, other in shadows.items())
        advice = f"pip uninstall {' '.join(dict.fromkeys(shadows.values()))}"
        return Finding(Verdict.WARNING, f"{named}, which takes precedence over tfloom's", advice, details)
    named = ", ".join(f"{name} from {origin}" for name, origin in list(others.items())[:3])
    if "rclpy" in others:
        advice = "take the real ROS out of PYTHONPATH, or run in a shell that hasn't sourced it"
        return Finding(Verdict.FAILED, f"a real ROS and tfloom are mixed: {named}", advice, details)
    advice = "if it is none of your own packages, take its folder out of PYTHONPATH"
    return Finding(Verdict.WARNING, f"what precedes tfloom's own: {named}", advice, details)


def _shadowing_distributions(others: dict[str, str]) -> dict[str, str]:
    """Return the distributions of pip that names are imported from, by name; empty with another `rclpy`, a real ROS."""
    if "rclpy" in others:
        return {}
    from importlib.metadata import distribution, packages_distributions

    shadows = {}
    distributions = packages_distributions()
    for name, origin in others.items():
        for candidate in distributions.get(name, ()):
            if Path(str(distribution(candidate).locate_file(name))) == Path(origin).parent:
                shadows[name] = candidate
    return shadows


def check_commands() -> Finding:
    """Check for a real ROS on the path."""
    commands = [
        str(Path(folder, "ros2"))
        for folder in dict.fromkeys(os.environ.get("PATH", "").split(os.pathsep))
        if shutil.which("ros2", path=folder)
    ]
    details = {
        "ros2": ", ".join(commands) or "not on the path",
        "ROS_DISTRO": os.environ.get("ROS_DISTRO", "not set"),
        "workspaces": ", ".join(index.search_paths()) or "none sourced",
    }
    # What is beside this Python is tfloom's own, as is a link to it, which `uv tool install` and pipx make; `samefile`
    # because either path may be a link.
    here = Path(sys.executable).parent
    real = [
        command
        for command in commands
        if not any(path.parent.samefile(here) for path in (Path(command), Path(command).resolve()))
    ]
    if real and len(commands) > len(real):
        return Finding(
            Verdict.WARNING,
            f"besides tfloom's, there is a ros2 in {real[0]}",
            f"the first on the path is run: {commands[0]}",
            details,
        )
    if real:
        return Finding(Verdict.WARNING, f"the command ros2 is {real[0]}", "tfloom's is `tfloom`", details)
    return Finding(Verdict.OK, f"no real ROS; workspaces: {details['workspaces']}", details=details)


def check_distribution() -> Finding:
    """Report which distribution is followed where they contradict each other."""
    given = os.environ.get("ROS_DISTRO", "")
    followed = ros_distro.ROS_DISTRO
    text = f"{followed} is followed where ROS 2's distributions contradict each other"
    details = {"ROS_DISTRO": given or "not set", "followed": followed}
    if not given.strip() or given == followed:
        return Finding(
            Verdict.OK, f"{text}: {'by ROS_DISTRO' if given else 'ROS_DISTRO is not set'}", "", details
        )
    return Finding(
        Verdict.WARNING,
        f"ROS_DISTRO is {shown_part(given)}, which tfloom does not know; {text}",
        f"set ROS_DISTRO to one of {', '.join(ros_distro.DISTRIBUTIONS)}; docs/distributions.md says what differs",
        details,
    )


def check_workspace() -> Finding:
    """Check whether what the packages of the workspace here ask for is there."""
    from tfloom.workspace.missing_dependencies import (
        find_missing,
        find_source,
        how_to_provide,
        read_requirements,
    )

    source = find_source()
    if source is None:
        return Finding(Verdict.OK, "no workspace here: no folder src with packages, here or above")
    requirements = read_requirements(source)
    details = {package.name: ", ".join(package.depends) or "nothing" for package in requirements}
    packages = f"{len(requirements)} package{'s' * (len(requirements) != 1)} in {source}"
    lacking = find_missing(requirements)
    if not lacking:
        return Finding(Verdict.OK, f"{packages}; what they ask for is there", details=details)
    named = ", ".join(f"{name} (for {', '.join(users)})" for name, users in lacking.items())
    advice = "; ".join(f"{name}: {how_to_provide(name)}" for name in lacking)
    return Finding(Verdict.WARNING, f"{packages} ask for what is missing: {named}", advice, details)


def check_versions() -> Finding:
    """Report the versions of Python, tfloom and its dependencies."""
    details = {
        "Python": platform.python_version(),
        "system": platform.platform(),
        "tfloom": tfloom.__version__,
        **{name: _version(name) for name in DISTRIBUTIONS},
    }
    return Finding(Verdict.OK, f"tfloom {details['tfloom']}, Python {details['Python']}", details=details)


def _version(distribution: str) -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(distribution)
    except PackageNotFoundError:
        return "not installed"


CHECKS: dict[str, Callable[..., Finding]] = {
    "wire": check_wire,
    "domain": check_domain,
    "network": check_network,
    "reach": check_reach,
    "round trip": check_round_trip,
    "peers": check_peers,
    "quality of service": check_qos,
    "services": check_services,
    "other wire": check_other_wire,
    "names": check_names,
    "commands": check_commands,
    "distribution": check_distribution,
    "workspace": check_workspace,
    "versions": check_versions,
}
PACKAGE_CHECKS = {"names", "versions"}
DOMAIN_CHECKS = {"peers", "quality of service", "services"}
"""Those that take a SharedDomain."""


def checks(*, exclude_packages: bool = False) -> dict[str, Callable[[], Finding]]:
    """Return the checks that apply here, by name.

    Args:
        exclude_packages: Leave out the versions, and the origin of each package.
    """
    shared = SharedDomain()
    chosen: dict[str, Callable[[], Finding]] = {
        name: partial(check, shared) if name in DOMAIN_CHECKS else check
        for name, check in CHECKS.items()
        if not (exclude_packages and name in PACKAGE_CHECKS)
    }
    if is_zenoh_selected():
        chosen["router"] = check_router
    return chosen
