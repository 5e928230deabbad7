"""foxglove_bridge: serve the graph to Foxglove."""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec

from tfloom.common.access import is_loopback
from tfloom.common.terminal import report
from tfloom.node.client_library import spin
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["main"]

NEEDED = {"foxglove": "foxglove-sdk", "websockets": "websockets"}
SDK_THREADS = 8
"""Number of the SDK's threads, at least: requests for parameters wait on some of them, and clients share the others."""
OPEN_TO_ALL = "Anyone who reaches this address can see what is published here, and can drive robots."


def main(args: list[str] | None = None) -> int:
    """Serve until stopped; return the exit code."""
    expect_no_arguments("foxglove_bridge", "Serve the graph to Foxglove, over a WebSocket.", args)
    for module, distribution in NEEDED.items():
        if find_spec(module) is None:
            hint = f"needs {distribution}, which is not installed: pip install 'tfloom[foxglove]'"
            report(f"foxglove_bridge: foxglove_bridge {hint}")
            return 1
    return run_program(args, _serve)


def _serve() -> int:
    from tfloom.foxglove.bridge import BridgeError, FoxgloveBridge
    from tfloom.foxglove.relay import SWITCH_INTERVAL_S
    from tfloom.foxglove.settings import SettingsError

    sys.setswitchinterval(SWITCH_INTERVAL_S)
    # Read by the SDK's runtime when its first server starts.
    os.environ.setdefault("TOKIO_WORKER_THREADS", str(max(SDK_THREADS, os.cpu_count() or 1)))
    try:
        bridge = FoxgloveBridge()
    except (BridgeError, SettingsError) as error:
        report(f"foxglove_bridge: {error}")
        return 1
    try:
        address = bridge.settings.address
        scheme = "ws" if bridge.settings.tls is None else "wss"
        bridge.get_logger().info(f"Server listening at {scheme}://{address}:{bridge.port}")
        if not is_loopback(address):
            bridge.get_logger().warning(OPEN_TO_ALL)
        spin(bridge)
    finally:
        bridge.close()
    return 0
