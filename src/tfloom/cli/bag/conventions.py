"""The conventions of `ros2 bag`, which its verbs share: arguments, and errors in the reference's form."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report

if TYPE_CHECKING:
    from tfloom.rmw.base import Participant

LOG_LEVELS = ["debug", "info", "warn", "error", "fatal"]
STORAGES = ["sqlite3", "mcap"]


def error(text: str) -> CommandError:
    """Return the error of a verb."""
    return CommandError(f"[ERROR] [ros2bag]: {text}")


def bag_path(text: str) -> str:
    """Return the path of a bag, which must exist."""
    if not Path(text).exists():
        raise argparse.ArgumentTypeError(f"Bag path '{text}' does not exist!")
    return text


def existing_file(text: str) -> str:
    """Return the path of a file, which must exist."""
    if not Path(text).is_file():
        raise argparse.ArgumentTypeError(f"File '{text}' does not exist!")
    return text


def regular_expression(text: str) -> str:
    """Return a valid regular expression."""
    try:
        re.compile(text)
    except re.error as problem:
        raise argparse.ArgumentTypeError(f"'{text}' is not a regular expression: {problem}") from None
    return text


def add_storage(parser: argparse.ArgumentParser, names: list[str] = STORAGES) -> None:
    """Add the flag for the storage of a bag that is read."""
    parser.add_argument(
        "-s",
        "--storage",
        choices=names,
        default="",
        help="storage of the bag (default: by its metadata, or by the names of its files)",
    )


@contextmanager
def explained() -> Iterator[None]:
    """Raise errors of bags as a verb's, and print warnings of bags as a line on stderr, for the block."""
    import warnings

    from tfloom.bag.errors import BagError, BagWarning

    show = warnings.showwarning

    def show_line(message: Warning | str, category: type[Warning], *rest: Any, **options: Any) -> None:
        if issubclass(category, BagWarning):
            report(f"[WARN] [ros2bag]: {message}")
        else:
            show(message, category, *rest, **options)

    with warnings.catch_warnings():
        warnings.simplefilter("always", BagWarning)
        warnings.showwarning = show_line
        try:
            yield
        except BagError as problem:
            raise error(str(problem)) from None


@contextmanager
def running_context(log_level: str) -> Iterator[None]:
    """Initialise the default context for the block, and set the level of all loggers.

    Ctrl-C, SIGTERM and a shutdown end the block without an error.
    """
    from tfloom.node.client_library import init
    from tfloom.node.context.utilities import get_default_context, try_shutdown
    from tfloom.node.log.logging import get_logging_severity_from_string, set_logger_level
    from tfloom.node.values.exceptions import ExternalShutdownException

    context = get_default_context()
    try:
        init(args=["ros2"])
        if log_level != "info":
            set_logger_level("", get_logging_severity_from_string(log_level.upper()))
        yield
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except Exception as problem:
        if not context.is_caused_by_signal(problem):
            raise
    finally:
        try_shutdown()


def learn_type(participant: Participant, type_name: str) -> None:
    """Make the classes of a type from the descriptions of the nodes that use it, where there are any."""
    from tfloom.cli.shared.peer_types import learn

    kind = type_name.split("/")[1] if type_name.count("/") == 2 else "msg"
    learn(participant, type_name.removesuffix("_Event") if kind == "srv" else type_name, kind)
