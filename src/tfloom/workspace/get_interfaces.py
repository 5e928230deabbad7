"""The functions of `rosidl_runtime_py` that list interfaces: of sourced workspaces, and tfloom's own."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from tfloom.rosidl import definition_files
from tfloom.workspace import index


def get_interface_packages() -> dict[str, str]:
    """Return the packages that have definitions, each with the folder that holds its own."""
    shares: dict[str, str] = {}
    for share in definition_files.share_folders():
        for folder in sorted(share.glob("*/")):
            if folder.name not in shares and definition_files.names_in(folder):
                shares[folder.name] = str(share)
    return shares


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the interfaces of packages, or of all, as `kind/Name`, sorted; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    packages = get_interface_packages()
    wanted = list(package_names) or sorted(packages)
    for name in wanted:
        _check_is_known(name, packages)
    return {name: _names(packages[name], name) for name in wanted if name in packages}


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages of packages, or of all of them, as `msg/Name`; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    return _of_kind("msg", package_names)


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services of packages, or of all of them, as `srv/Name`; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    return _of_kind("srv", package_names)


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions of packages, or of all of them, as `action/Name`; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    return _of_kind("action", package_names)


def get_interface_path(interface_name: str) -> str:
    """Return the file that defines an interface.

    Args:
        interface_name: `package/kind/Name`, with or without a suffix: `.kind`, or `.idl` of a built package.

    Raises:
        ValueError: it has fewer than two parts, an empty one, or `..`.
        LookupError: the package, or the interface in it, is unknown.
    """
    parts = interface_name.split("/")
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{interface_name}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain empty parts")
    if ".." in parts:
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain '..'")
    packages = get_interface_packages()
    _check_is_known(parts[0], packages)
    suffixes = ("",) if "." in parts[-1] else (f".{parts[-2]}", ".idl")
    for share in definition_files.share_folders():
        for suffix in suffixes:
            path = share / f"{interface_name}{suffix}"
            if path.is_file():
                return str(path)
    of_package = packages.get(parts[0]) or index.share_folder(parts[0], index.find_package(parts[0])).parent
    missing = Path(of_package, f"{interface_name}{suffixes[-1]}")
    raise LookupError(f"Could not find the interface '{missing}'")


def _check_is_known(package: str, with_interfaces: Iterable[str]) -> None:
    if (
        package not in with_interfaces
        and package not in index.own_packages()
        and not index.find_package(package)
    ):
        raise LookupError(f"Unknown package '{package}'")


def _names(share: str, package: str) -> list[str]:
    return [name.partition("/")[2] for name in definition_files.names_in(Path(share) / package)]


def _of_kind(kind: str, package_names: Iterable[str]) -> dict[str, list[str]]:
    interfaces = {
        package: [name for name in names if name.startswith(f"{kind}/")]
        for package, names in get_interfaces(package_names).items()
    }
    return {package: names for package, names in interfaces.items() if names}
