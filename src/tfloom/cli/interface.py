"""`interface`: definitions of messages, services and actions.

Most verbs only read names: what the others need beside these is imported inside their functions.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.cli.shared.errors import CommandError, standard_input
from tfloom.cli.shared.listing import print_json, print_names
from tfloom.cli.shared.names import did_you_mean
from tfloom.common.terminal import report
from tfloom.rosidl.definition_files import KINDS, interfaces_of
from tfloom.workspace.interfaces import expanded_definition, interface_packages, known_interfaces

if TYPE_CHECKING:
    from tfloom.rosidl.message import Message

TITLES = {"msg": "Messages", "srv": "Services", "action": "Actions"}


def add_kind_flags(parser: argparse.ArgumentParser) -> None:
    """Add the flags that select messages, services or actions only."""
    parser.add_argument("-m", "--only-msgs", action="store_true", help="messages only")
    parser.add_argument("-s", "--only-srvs", action="store_true", help="services only")
    parser.add_argument("-a", "--only-actions", action="store_true", help="actions only")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def requested_kinds(args: argparse.Namespace) -> list[str]:
    """Return the kinds that the flags select; all without a flag."""
    asked = dict(zip(KINDS, (args.only_msgs, args.only_srvs, args.only_actions), strict=True))
    return [kind for kind in KINDS if asked[kind]] or list(KINDS)


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface list`."""
    add_kind_flags(parser)


def list_main(args: argparse.Namespace) -> int:
    """Print the names of each kind under the kind's title."""
    names = {kind: known_interfaces(kind) for kind in requested_kinds(args)}
    if args.json:
        print_json(names)
        return 0
    for kind, of_kind in names.items():
        print(f"{TITLES[kind]}:")
        for name in of_kind:
            print(f"    {name}")
    return 0


def add_package_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface package`."""
    parser.add_argument("package_name", help="name of the package")
    add_kind_flags(parser)


def package_main(args: argparse.Namespace) -> int:
    """Print the interfaces, kind by kind, each kind in order of the names."""
    packages = interface_packages()
    folder = packages.get(args.package_name)
    if folder is None:
        raise CommandError(
            f"Unknown package '{args.package_name}'{did_you_mean(args.package_name, packages)}"
        )
    names = [
        f"{args.package_name}/{kind}/{name}"
        for kind in requested_kinds(args)
        for name in interfaces_of(folder, kind)
    ]
    print_names(names, as_json=args.json)
    return 0


def add_packages_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface packages`."""
    add_kind_flags(parser)


def packages_main(args: argparse.Namespace) -> int:
    """Print the packages in order of their names."""
    kinds = requested_kinds(args)
    names = [
        package
        for package, folder in interface_packages().items()
        if any(interfaces_of(folder, kind) for kind in kinds)
    ]
    print_names(names, as_json=args.json)
    return 0


def add_proto_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface proto`."""
    parser.add_argument("--no-quotes", action="store_true", help="print without quotes")
    parser.add_argument("type", help="name of the interface, for example geometry_msgs/msg/Twist")


def proto_main(args: argparse.Namespace) -> int:
    """Print the default values of the interface's fields, as YAML."""
    quote = "" if args.no_quotes else '"'
    print(f"{quote}{interface_to_yaml(args.type)}{quote}")
    return 0


def interface_to_yaml(identifier: str) -> str:
    """Return the defaults of a message, a service's request or an action's goal, as YAML.

    Raises:
        CommandError: there is no such interface.
    """
    from tfloom.rosidl.yaml_text import message_to_yaml

    return message_to_yaml(class_to_send(identifier)())


def type_completer(**_: Any) -> list[str]:
    """Return the full names of all messages, services and actions."""
    return known_interfaces()


def package_name_completer(**_: Any) -> list[str]:
    """Return the names of the packages that define interfaces."""
    return list(interface_packages())


def class_to_send(name: str) -> type[Message]:
    """Return the class that a user sends: the message, the request or the goal."""
    from tfloom.cli.shared.interfaces import action_class, message_class, service_class

    kind = name.split("/")[1:-1]
    if kind == ["srv"]:
        request: type[Message] = service_class(name).Request
        return request
    if kind == ["action"]:
        goal: type[Message] = action_class(name).Goal
        return goal
    return message_class(name)


def add_show_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface show`."""
    comments = parser.add_mutually_exclusive_group()
    comments.add_argument("--all-comments", action="store_true", help="show comments of nested types, too")
    comments.add_argument("--no-comments", action="store_true", help="show no comments and no empty lines")
    parser.add_argument(
        "type",
        help="name of the interface, for example std_msgs/msg/String; - reads names from standard input",
    )


def show_main(args: argparse.Namespace) -> int:
    """Print the definition of each name."""
    comments = "all" if args.all_comments else "none" if args.no_comments else "own"
    names: Iterable[str] = [args.type] if args.type != "-" else map(str.strip, standard_input())
    try:
        for line in chain.from_iterable(expanded_definition(name, comments) for name in names):
            print(line)
    except LookupError as error:
        raise CommandError(str(error.args[0])) from None
    return 0


def add_stubs_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `interfaces stubs` takes."""
    parser.add_argument(
        "folder",
        metavar="DIR",
        help="where to write; VS Code and pyright look in `typings` of the project, mypy where MYPYPATH says",
    )


def stubs_main(args: argparse.Namespace) -> int:
    """Write the modules and print their paths; on stderr, print what is left out, and why."""
    from tfloom.workspace.interface_stubs import write_stubs

    stubs = write_stubs(Path(args.folder))
    if not stubs.written and not stubs.left_out:
        raise CommandError(
            "No package on AMENT_PREFIX_PATH holds definitions: source the setup file of a workspace that has some"
        )
    for path in stubs.written:
        print(f"creating {path}")
    for reason in stubs.left_out:
        report(reason)
    return 1 if stubs.left_out else 0
