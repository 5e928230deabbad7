"""set_parameters_callback: set one parameter when another is set, by the pre-set, on-set and post-set callbacks.

`ros2 param set /set_parameters_callback param1 28.0` sets param2 to 4.0 as well.
"""

from __future__ import annotations

from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["SetParametersCallback", "main"]

FIRST, SECOND = "param1", "param2"
SECOND_VALUE = 4.0


class SetParametersCallback(Node):
    """Declares param1 and param2, and stores their values in attributes, too."""

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


def main(args: list[str] | None = None) -> int:
    """Serve the parameters until stopped; return the exit code."""
    expect_no_arguments(
        "set_parameters_callback",
        "Declare the parameters param1 and param2; setting the first sets both.",
        args,
    )
    return run_program(args, lambda: spin(SetParametersCallback()))
