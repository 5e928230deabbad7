"""parameter_blackboard: a node that stores all parameters that clients set; async_param_client sets some."""

from __future__ import annotations

from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["ParameterBlackboard", "main"]


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


def main(args: list[str] | None = None) -> int:
    """Store parameters until stopped; return the exit code."""
    expect_no_arguments("parameter_blackboard", "Store all parameters that clients set.", args)
    return run_program(args, lambda: spin(ParameterBlackboard()))
