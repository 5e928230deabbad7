"""Parameters: a node that stores all that clients set, one with callbacks, and a client."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.client_library import ok, spin, spin_until_future_complete
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import (
    Parameter,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)
from tfloom.node.program import expect_no_arguments, run_program

__all__ = [
    "ParameterBlackboard",
    "SetParametersCallback",
    "async_param_client_main",
    "parameter_blackboard_main",
    "set_parameters_callback_main",
]


class ParameterBlackboard(Node):
    """Allows every parameter, and declares those of its command line."""

    def __init__(self) -> None:
        super().__init__(
            "parameter_blackboard",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        count = len(self.get_parameters_by_prefix(""))
        self.get_logger().info(
            f"Parameter blackboard node named '{self.get_fully_qualified_name()}' ready, "
            f"and serving '{count}' parameters already!"
        )


def parameter_blackboard_main(args: list[str] | None = None) -> int:
    """Store parameters until stopped; return the exit code."""
    expect_no_arguments("parameter_blackboard", "Store all parameters that clients set.", args)
    return run_program(args, lambda: spin(ParameterBlackboard()))


FIRST, SECOND = "param1", "param2"
SECOND_VALUE = 4.0


class SetParametersCallback(Node):
    """Declares param1 and param2, and stores their values in attributes, too.

    `ros2 param set /set_parameters_callback param1 28.0` sets param2 to 4.0 as well.
    """

    def __init__(self) -> None:
        super().__init__("set_parameters_callback")
        self.internal_tracked_param_1 = self.declare_parameter(FIRST, 0.0).value
        self.internal_tracked_param_2 = self.declare_parameter(SECOND, 0.0).value
        self.add_pre_set_parameters_callback(self.add_second)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.track)

    def add_second(self, parameter_list: list[Parameter]) -> list[Parameter]:
        """Return the parameters to set instead of `parameter_list`."""
        second = Parameter(SECOND, Parameter.Type.DOUBLE, SECOND_VALUE)
        return parameter_list + [second for parameter in parameter_list if parameter.name == FIRST]

    def judge(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Return whether all of them may be set."""
        result = SetParametersResult(successful=True)
        for parameter in parameter_list:
            if parameter.name in {FIRST, SECOND}:
                result.reason = f"success {parameter.name}"
        return result

    def track(self, parameter_list: list[Parameter]) -> None:
        """Store the values that have been set."""
        for parameter in parameter_list:
            if parameter.name == FIRST:
                self.internal_tracked_param_1 = parameter.value
            elif parameter.name == SECOND:
                self.internal_tracked_param_2 = parameter.value


def set_parameters_callback_main(args: list[str] | None = None) -> int:
    """Serve the parameters until stopped; return the exit code."""
    expect_no_arguments(
        "set_parameters_callback",
        "Declare the parameters param1 and param2; setting the first sets both.",
        args,
    )
    return run_program(args, lambda: spin(SetParametersCallback()))


BLACKBOARD = "parameter_blackboard"
MISSING = (
    "parameter_blackboard is not available, start parameter blackboard with "
    "`ros2 run demo_nodes_py parameter_blackboard` before running this demo"
)
FILE = Path(__file__).with_name("params.yaml")
PATIENCE_S = 3.0


class Tour:
    """The demonstration, step by step.

    Args:
        node: The node of the client.
        client: Client of the other node's parameters.
    """

    def __init__(self, node: Node, client: AsyncParameterClient) -> None:
        self._node = node
        self._client = client

    def run(self) -> None:
        """Run all steps, and log the outcome of each."""
        parameters = [
            Parameter("int_parameter", Parameter.Type.INTEGER, 10),
            Parameter("bool_parameter", Parameter.Type.BOOL, False),
            Parameter("string_parameter", Parameter.Type.STRING, "Fee Fi Fo Fum"),
        ]
        names = [parameter.name for parameter in parameters]

        self._say("Setting parameters:")
        results = self._wait(self._client.set_parameters(parameters)).results
        for name, result in zip(names, results, strict=True):
            self._say(f"    {name}:", f"        successful: {result.successful}")

        self._say("Listing Parameters:")
        listed = self._wait(self._client.list_parameters(names, 10))
        self._say(*(f"    - {name}" for name in listed.result.names))

        self._say("Getting parameters:")
        got = self._wait(self._client.get_parameters(names))
        for name, value in zip(names, got.values, strict=True):
            self._say(f"    - {name}: {parameter_value_to_python(value)}")

        self._say("Loading parameters: ")
        results = self._wait(self._client.load_parameter_file(str(FILE))).results
        loaded = parameter_dict_from_yaml_file(FILE, target_nodes=[BLACKBOARD])
        for (name, message), result in zip(loaded.items(), results, strict=True):
            value = parameter_value_to_python(message.value)
            self._say(f"    {name}:", f"        successful: {result.successful}", f"        value: {value}")

        self._say("Deleting parameters: ")
        # The first two were loaded from the file, the last one was set above.
        deleted_names = ["other_int_parameter", "other_string_parameter", "string_parameter"]
        results = self._wait(self._client.delete_parameters(deleted_names)).results
        for name, result in zip(deleted_names, results, strict=True):
            self._say(
                f"    {name}:", f"        successful: {result.successful}", f"        reason: {result.reason}"
            )

    def _say(self, *lines: str) -> None:
        for line in lines:
            self._node.get_logger().info(line)

    def _wait(self, future: Future[Any]) -> Any:
        spin_until_future_complete(self._node, future)
        return future.result()


def run_tour() -> int:
    """Run all steps; return the exit code, 1 without the other node."""
    node = Node("async_param_client")
    client = AsyncParameterClient(node, BLACKBOARD)
    if not client.wait_for_services(PATIENCE_S):
        if ok():
            report(MISSING)
        return 1
    Tour(node, client).run()
    return 0


def async_param_client_main(args: list[str] | None = None) -> int:
    """Run the demonstration; return the exit code."""
    expect_no_arguments(
        "async_param_client",
        "Set, list, get, load and delete parameters of the node parameter_blackboard.",
        args,
    )
    return run_program(args, run_tour)
