"""The common part of the verbs about packages."""

from __future__ import annotations

from tfloom.cli.errors import CommandError
from tfloom.cli.names import did_you_mean
from tfloom.workspace import index


def package_prefix(package: str) -> str | None:
    """Return the prefix of a workspace's package, or None for one of tfloom's own.

    Raises:
        CommandError: there is no such package; the text has the nearest names.
    """
    prefix = index.find_package(package)
    own = index.own_packages()
    if prefix is None and package not in own:
        raise CommandError(f"Package not found{did_you_mean(package, {*own, *index.workspace_packages()})}")
    return prefix
