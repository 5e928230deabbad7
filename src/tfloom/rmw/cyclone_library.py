"""The path of libddsc in the wheel of cyclonedds, found without importing that package."""

from __future__ import annotations

import os
import re
from importlib.machinery import PathFinder

from tfloom.rmw.errors import NoBackendError

SUPPORTED_MAJOR = 11

_INSTALL = "install it with: pip install 'cyclonedds>=11,<12'"
_ELSEWHERE = (
    "(it has wheels for Python 3.10 to 3.13 on Linux x86_64, macOS and Windows); "
    "within one process, RMW_IMPLEMENTATION=tfloom_local needs nothing"
)


_PLACES = (("../cyclonedds.libs", re.compile(r".*ddsc[-.]")), (".dylibs", re.compile("libddsc")))
"""Where wheels have it, relative to the package: on Linux and Windows, and on macOS."""


def find_library() -> str:
    """Return the path of libddsc.

    Raises:
        NoBackendError: cyclonedds isn't installed, isn't version 11, or came without its library.
    """
    package = _find_package()
    _check_version(package)
    for place, name in _PLACES:
        folder = f"{package}/{place}"
        if found := sorted(filter(name.match, _names_in(folder))):
            return os.path.realpath(f"{folder}/{found[0]}")
    raise NoBackendError(
        f"cyclonedds in {package} came without libddsc: it wasn't installed from a wheel; {_INSTALL}"
    )


def _find_package() -> str:
    spec = PathFinder.find_spec("cyclonedds")
    if spec is None or not spec.submodule_search_locations:
        raise NoBackendError(f"there is no DDS: cyclonedds isn't installed; {_INSTALL} {_ELSEWHERE}")
    return next(iter(spec.submodule_search_locations))


def _check_version(package: str) -> None:
    for metadata in _names_in(f"{package}/.."):
        if metadata.startswith("cyclonedds-") and metadata.endswith(".dist-info"):
            version = metadata.removeprefix("cyclonedds-").removesuffix(".dist-info")
            if version.partition(".")[0] != str(SUPPORTED_MAJOR):
                raise NoBackendError(f"cyclonedds {version} in {package} can't be used; {_INSTALL}")


def _names_in(folder: str) -> list[str]:
    # By os alone, because importing pathlib would take longer than the rest of this module.
    try:
        return [entry.name for entry in os.scandir(folder)]
    except OSError:
        return []
