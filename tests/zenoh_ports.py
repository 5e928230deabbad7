"""A port for the routers of a test, which no other test on this machine uses."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import pytest
from tests.conftest import hold_domain

FIRST_PORT = 7447
PORTS_OF_A_DOMAIN = 250


NEEDS_ZENOH = pytest.mark.skipif(
    find_spec("zenoh") is None, reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'"
)
NAMES = (
    *("ZENOH_SESSION_CONFIG_URI", "ZENOH_ROUTER_CONFIG_URI", "ZENOH_CONFIG_OVERRIDE", "ROS_STATIC_PEERS"),
    *("ZENOH_ROUTER_CHECK_ATTEMPTS", "TFLOOM_LEASE_S", "RUST_LOG"),
)


NOT_ON_ZENOH = {
    "test_command_with_the_other_type_is_told_the_type": "the type is in the key there",
    "test_transforms_are_received_while_the_gil_is_held": "each message calls Python there",
    "test_a_publisher_that_listeners_do_not_hear_is_named": "they hear it, whatever its quality of service",
    "test_incompatible_endpoints_are_reported_on_both_sides": "the text differs: tests/rmw/test_zenoh_wire.py has it",
    "test_node_that_is_listed_after_its_transforms_is_named": "a writer's token names its node there",
    "test_requests_to_a_buffer_server": "a bystander can't read requests there",
    "test_listener_logs_the_messages_of_the_talker": "prints the padding of DDS",
    "test_topic_of_an_unknown_type_is_said_once": "the hash of a type must be known there",
}
"""The tests that `TFLOOM_TEST_WIRE=rmw_zenoh_cpp` leaves out, and why."""


def leave_out(items: list[pytest.Item], folder: Path, names: Mapping[str, str]) -> None:
    """Remove what Zenoh can't do from the tests of a folder that run on it too.

    Args:
        items: All tests, which lose those.
        folder: The folder.
        names: The names of the test functions, each with the reason.
    """
    items[:] = [
        item
        for item in items
        if not (item.path.parent == folder and "zenoh" in item.name and item.name.partition("[")[0] in names)
    ]


@contextmanager
def use_port_of(domain: int) -> Iterator[int]:
    """Set TFLOOM_ZENOH_PORT to the port that goes with a domain that is held. Nothing else configures Zenoh."""
    with pytest.MonkeyPatch.context() as patch:
        for name in NAMES:
            patch.delenv(name, raising=False)
        port = FIRST_PORT + PORTS_OF_A_DOMAIN * domain
        patch.setenv("TFLOOM_ZENOH_PORT", str(port))
        yield port


@contextmanager
def hold_zenoh_port() -> Iterator[int]:
    """Hold a domain of this machine, and use the port that goes with it; see `use_port_of`."""
    with hold_domain() as domain, use_port_of(domain) as port:
        yield port
