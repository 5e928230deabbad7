"""Set a node's parameters from a YAML file."""

from __future__ import annotations

import argparse
from typing import Any

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import nodes_with_parameters
from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import Parameter


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param load`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_file", help="the YAML file")
    parser.add_argument(
        "--no-use-wildcard", action="store_true", help="skip the parameters for /** in the file"
    )


def main(args: argparse.Namespace) -> int:
    """Set the parameters one by one, print each outcome, and return 1 if one doesn't have the file's value then."""
    refused: list[Parameter] = []
    with nodes_with_parameters(args, args.node_name) as nodes:
        node, services = nodes[0]
        parameters = [_parameter(name, value) for name, value in _values(args, node).items()]
        for parameter, result in zip(parameters, services.set(parameters), strict=True):
            reason = f": {result.reason}" if result.reason else ""
            if result.successful:
                print(f"Set parameter {parameter.name} successful{reason}")
            else:
                report(f"Set parameter {parameter.name} failed{reason}")
                refused.append(parameter)
        # A dump has the read-only parameters, too, which have this value.
        values = services.values([parameter.name for parameter in refused]) if refused else []
    return 0 if values == [parameter.value for parameter in refused] else 1


def _values(args: argparse.Namespace, node: str) -> dict[str, Any]:
    from tfloom.node.parameters.parameter import no_parameters_text
    from tfloom.node.parameters.parameter_file import read_parameter_file

    try:
        rules = read_parameter_file(args.parameter_file)
    except OSError as error:
        raise CommandError(f"can't read {args.parameter_file}: {error.strerror}") from None
    except ValueError as error:
        raise CommandError(str(error)) from None
    values = {
        rule.name: rule.value
        for rule in rules
        if rule.is_for(node) and not (args.no_use_wildcard and "*" in rule.node)
    }
    if not values:
        nodes = list(dict.fromkeys(rule.node for rule in rules))
        raise CommandError(no_parameters_text(node, nodes))
    return values


def _parameter(name: str, value: Any) -> Parameter:
    from tfloom.node.parameters.parameter import Parameter as ParameterOfNode

    return ParameterOfNode(name, value=value).to_parameter_msg()
