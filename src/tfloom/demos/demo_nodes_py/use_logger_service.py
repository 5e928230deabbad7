"""use_logger_service: set the logger level of another node by its services, and let it log at each level."""

from __future__ import annotations

import threading
from contextlib import suppress
from typing import Any

from tfloom.interfaces.rcl_interfaces.msg import LoggerLevel
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin_until_future_complete
from tfloom.node.endpoints.client import Client
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.values.exceptions import ExternalShutdownException

__all__ = ["LoggerServiceNode", "TestNode", "main"]

REMOTE = "LoggerServiceNode"
LEVELS = {"debug": LoggingSeverity.DEBUG, "warn": LoggingSeverity.WARN, "error": LoggingSeverity.ERROR}
PATIENCE_S = 5.0


class LoggerServiceNode(Node):
    """Logs the messages on output at four levels; its services set the least severity that is logged."""

    def __init__(self) -> None:
        super().__init__(REMOTE, enable_logger_service=True)
        self.heard = threading.Semaphore(0)
        self.sub = self.create_subscription(String, "output", self.callback, 10)

    def callback(self, msg: String) -> None:
        """Log a message once at each level, so that the output shows which levels are on."""
        self.get_logger().debug(f"{msg.data} with DEBUG logger level.")
        self.get_logger().info(f"{msg.data} with INFO logger level.")
        self.get_logger().warning(f"{msg.data} with WARN logger level.")
        self.get_logger().error(f"{msg.data} with ERROR logger level.")
        self.heard.release()


class TestNode(Node):
    """Sets and gets another node's level, and publishes messages for it to log.

    Args:
        remote_node_name: The other node; its logger has its name.
    """

    __test__ = False
    """Excludes the class from test runners, which collect classes by such names."""

    def __init__(self, remote_node_name: str) -> None:
        super().__init__("TestNode")
        self._remote = remote_node_name
        self.pub = self.create_publisher(String, "output", 10)
        self._getter = self.create_client(GetLoggerLevels, f"{remote_node_name}/get_logger_levels")
        self._setter = self.create_client(SetLoggerLevels, f"{remote_node_name}/set_logger_levels")

    def set_logger_level_on_remote_node(self, logger_level: int) -> bool:
        """Set the level, one of LoggingSeverity; return whether that succeeded."""
        level = LoggerLevel(name=self._remote, level=int(logger_level))
        response = self._call(self._setter, SetLoggerLevels.Request(levels=[level]))
        if response is None:
            return False
        result = response.results[0]
        if not result.successful:
            self.get_logger().error(f"Failed to change logger level: {result.reason}")
        return bool(result.successful)

    def get_logger_level_on_remote_node(self) -> int | None:
        """Return the level, 0 if none was set; None without a response."""
        response = self._call(self._getter, GetLoggerLevels.Request(names=[self._remote]))
        return None if response is None else int(response.levels[0].level)

    def _call(self, client: Client, request: Any) -> Any:
        if not client.wait_for_service(PATIENCE_S):
            return None
        future = client.call_async(request)
        spin_until_future_complete(self, future, timeout_sec=PATIENCE_S)
        return future.result()


def show(remote: LoggerServiceNode, node: TestNode) -> None:
    """At each level: set it, publish a message that the remote node logs, and get it."""
    for count, name in enumerate(["default", *LEVELS], 1):
        node.get_logger().info(f"Output with {name} logger level:")
        if name in LEVELS and not node.set_logger_level_on_remote_node(LEVELS[name]):
            node.get_logger().error(f"Failed to set {name} logger level via logger service !")
        else:
            node.pub.publish(String(data=f"Output {count}"))
            remote.heard.acquire(timeout=PATIENCE_S)
        level = node.get_logger_level_on_remote_node()
        if level is None:
            node.get_logger().error("Failed to get logger level via logger service !")
        else:
            node.get_logger().info(f"Current logger level: {level}")


def run() -> None:
    """Spin the remote node on a thread, and demonstrate its services."""
    remote, node = LoggerServiceNode(), TestNode(REMOTE)
    executor = SingleThreadedExecutor()
    executor.add_node(remote)

    def spin() -> None:
        with suppress(ExternalShutdownException):
            executor.spin()

    thread = threading.Thread(target=spin)
    thread.start()
    try:
        show(remote, node)
    finally:
        executor.shutdown()
        thread.join()


def main(args: list[str] | None = None) -> int:
    """Run the demonstration; return the exit code."""
    expect_no_arguments("use_logger_service", "Set a node's logger level by its services.", args)
    return run_program(args, run)
