"""Set parameters."""

from __future__ import annotations

import argparse
from itertools import starmap

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import requested_node
from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import Parameter


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param set`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_name", help="name of the parameter")
    parser.add_argument("value", help="its value in YAML, for example 150, true, abc or '[1, 2]'")
    parser.add_argument("further", nargs="*", help="further parameters, each with its value")
    parser.add_argument("--atomic", action="store_true", help="set all of the parameters, or none")


def main(args: argparse.Namespace) -> int:
    """Set the parameters and print the outcome; of several, each after its name. Return 1 if one wasn't set."""
    if len(args.further) % 2:
        raise CommandError(f"{args.further[-1]} has no value: each further parameter is a name and a value")
    words = [args.parameter_name, args.value, *args.further]
    parameters = list(starmap(_parameter, zip(words[::2], words[1::2], strict=True)))
    names = [parameter.name for parameter in parameters]
    if len({*names}) < len(names):
        raise CommandError(f"a parameter is given twice: {' '.join(names)}")
    with requested_node(args) as services:
        if args.atomic:
            outcomes = {"": services.set_atomically(parameters)}
        else:
            outcomes = dict(zip(names, services.set(parameters), strict=True))
    for name, outcome in outcomes.items():
        start = f"{name}: " if len(outcomes) > 1 else ""
        reason = f": {outcome.reason}" if outcome.reason else ""
        if outcome.successful:
            print(f"{start}Set {_what(parameters, args)} successful{reason}")
        else:
            report(f"{start}Setting {_what(parameters, args)} failed{reason}")
    return 0 if all(outcome.successful for outcome in outcomes.values()) else 1


def _what(parameters: list[Parameter], args: argparse.Namespace) -> str:
    return "parameters" if args.atomic and len(parameters) > 1 else "parameter"


def _parameter(name: str, text: str) -> Parameter:
    """Return a parameter with the value that a text stands for.

    Raises:
        CommandError: it stands for no value of a parameter.
    """
    from tfloom.node.parameters.parameter import get_parameter_value

    try:
        return Parameter(name=name, value=get_parameter_value(text))
    except ValueError as error:
        raise CommandError(f"The value of {name} can't be used: {error}") from None
