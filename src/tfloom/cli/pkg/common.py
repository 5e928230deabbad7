"""The common part of the verbs about packages."""

from __future__ import annotations

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import way_to_package
from tfloom.workspace import index


def package_prefix(package: str) -> str | None:
    """Return the prefix of a workspace's package, or None for one of tfloom's own.

    Raises:
        CommandError: there is no such package; the text has the nearest names.
    """
    prefix = index.find_package(package)
    own = index.own_packages()
    if prefix is None and package not in own:
        names = {*own, *index.workspace_packages()}
        raise CommandError(f"Package not found{way_to_package(package, names)}")
    return prefix
