"""A port for the routers of a test, which no other test on this machine uses."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from tests.conftest import hold_domain

FIRST_PORT = 7447
PORTS_OF_A_DOMAIN = 250


@contextmanager
def hold_zenoh_port() -> Iterator[int]:
    """Hold a domain of this machine and the port that goes with it, and set TFLOOM_ZENOH_PORT to that.

    Nothing of the user's environment configures Zenoh meanwhile.
    """
    names = (
        "ZENOH_SESSION_CONFIG_URI",
        "ZENOH_ROUTER_CONFIG_URI",
        "ZENOH_CONFIG_OVERRIDE",
        "ROS_STATIC_PEERS",
    )
    with hold_domain() as domain, pytest.MonkeyPatch.context() as patch:
        for name in (*names, "ZENOH_ROUTER_CHECK_ATTEMPTS", "TFLOOM_LEASE_S", "RUST_LOG"):
            patch.delenv(name, raising=False)
        port = FIRST_PORT + PORTS_OF_A_DOMAIN * domain
        patch.setenv("TFLOOM_ZENOH_PORT", str(port))
        yield port
