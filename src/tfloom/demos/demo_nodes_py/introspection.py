"""introspection: a client and a server of add_two_ints that publish their traffic.

The content of add_two_ints/_service_event is set by a parameter of each: `client_configure_introspection` of the node
introspection_client, and `service_configure_introspection` of introspection_service: disabled, metadata or contents.
"""

from __future__ import annotations

from typing import Any

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult
from tfloom.node.endpoints.client import Client
from tfloom.node.endpoints.service import Service
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.qos.qos import qos_profile_system_default

__all__ = ["IntrospectionClientNode", "IntrospectionServiceNode", "check_parameter", "main"]

STATES = {
    "disabled": ServiceIntrospectionState.OFF,
    "metadata": ServiceIntrospectionState.METADATA,
    "contents": ServiceIntrospectionState.CONTENTS,
}
PERIOD_S = 0.5


def check_parameter(parameter_list: list[Parameter], parameter_name: str) -> SetParametersResult:
    """Return whether the parameter of that name, if it is to be set, has a valid value."""
    for parameter in parameter_list:
        if parameter.name != parameter_name:
            continue
        if parameter.type_ != Parameter.Type.STRING:
            return SetParametersResult(successful=False, reason="must be a string")
        if parameter.value not in STATES:
            return SetParametersResult(
                successful=False, reason="must be one of 'disabled', 'metadata', or 'contents"
            )
    return SetParametersResult(successful=True)


class _IntrospectedNode(Node):
    """A node whose client or service is configured by a parameter."""

    def configure_by(self, parameter_name: str, end: Client | Service) -> None:
        """Declare the parameter, and configure `end` by it whenever it is set."""

        def configure(parameters: list[Parameter]) -> None:
            for parameter in parameters:
                if parameter.name == parameter_name:
                    state = STATES[str(parameter.value)]
                    end.configure_introspection(self.get_clock(), qos_profile_system_default, state)

        self.add_on_set_parameters_callback(lambda parameters: check_parameter(parameters, parameter_name))
        self.add_post_set_parameters_callback(configure)
        self.declare_parameter(parameter_name, "disabled")


class IntrospectionClientNode(_IntrospectedNode):
    """Requests the sum of 2 and 3, half a second after the last response."""

    def __init__(self) -> None:
        super().__init__("introspection_client")
        self.cli = self.create_client(AddTwoInts, "add_two_ints")
        self.configure_by("client_configure_introspection", self.cli)
        self.future: Any = None
        self.timer = self.create_timer(PERIOD_S, self.timer_callback)

    def timer_callback(self) -> None:
        """Send a request, or log the response."""
        if self.future is None:
            if self.cli.service_is_ready():
                self.future = self.cli.call_async(AddTwoInts.Request(a=2, b=3))
        elif self.future.done():
            self.get_logger().info(f"Result of add_two_ints: {self.future.result().sum}")
            self.future = None


class IntrospectionServiceNode(_IntrospectedNode):
    """Serves add_two_ints, with introspection as its parameter says."""

    def __init__(self) -> None:
        super().__init__("introspection_service")
        self.srv = self.create_service(AddTwoInts, "add_two_ints", self.add_two_ints_callback)
        self.configure_by("service_configure_introspection", self.srv)

    def add_two_ints_callback(self, request: Any, response: Any) -> Any:
        """Reply to a request."""
        response.sum = request.a + request.b
        self.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response


def run() -> None:
    """Spin the server and the client in one executor."""
    with SingleThreadedExecutor() as executor:
        nodes = IntrospectionServiceNode(), IntrospectionClientNode()
        for node in nodes:
            executor.add_node(node)
        executor.spin()


def main(args: list[str] | None = None) -> int:
    """Call and serve until stopped; return the exit code."""
    expect_no_arguments(
        "introspection",
        "Call and serve add_two_ints; publish events on add_two_ints/_service_event, as set by the parameters "
        "client_configure_introspection and service_configure_introspection.",
        args,
    )
    return run_program(args, run)
