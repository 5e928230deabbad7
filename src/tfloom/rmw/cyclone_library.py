"""The path of libddsc in the wheel of cyclonedds, found without importing that package."""

from __future__ import annotations

import os
import re
import sys
from functools import lru_cache
from importlib.machinery import PathFinder

from tfloom.rmw.errors import ForkedError, NoBackendError

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
        NoBackendError: cyclonedds isn't installed, or came without its library.
    """
    package = _find_package()
    for place, name in _PLACES:
        folder = f"{package}/{place}"
        if names := sorted(filter(name.match, _names_in(folder))):
            return os.path.realpath(f"{folder}/{names[0]}")
    raise NoBackendError(
        f"cyclonedds in {package} came without libddsc: it wasn't installed from a wheel; {_INSTALL}"
    )


@lru_cache(maxsize=1)
def copy_library() -> str:
    """Return the path of a copy of libddsc in memory, for a process that was forked while its parent used the library.

    dlopen loads the copy as a library of its own. That one has neither the parent's participants nor locks that wait
    for the parent's threads.

    Raises:
        NoBackendError: as `find_library`.
        ForkedError: the system has no files in memory: it isn't Linux.
    """
    if sys.platform != "linux":
        raise ForkedError(
            "a process that was forked from one with a node can't use DDS on this system: start it by "
            "multiprocessing's method 'spawn', or fork before the first node is created"
        )
    from pathlib import Path

    # The descriptor stays open, so that a copy for a later fork has another name, by which dlopen distinguishes them.
    copy = os.memfd_create("libddsc")
    with Path(find_library()).open("rb") as library:
        while os.sendfile(copy, library.fileno(), None, 2**30):
            pass
    return f"/proc/self/fd/{copy}"


def open_library(path: str | None = None) -> tuple[str, str]:
    """Open libddsc, and return its path and its version; the version is empty if the library records none.

    A version that was not tried passes a self-test of its interface first.

    Args:
        path: Path of the library; None: that of `find_library`.

    Raises:
        NoBackendError: there is no libddsc, it isn't version 11, or it fails the self-test.
    """
    from tfloom._native import open_dds_library

    path = find_library() if path is None else path
    try:
        return path, open_dds_library(path)
    except RuntimeError as error:
        raise NoBackendError(f"the DDS library can't be used: {error}") from None


def _find_package() -> str:
    spec = PathFinder.find_spec("cyclonedds")
    if spec is None or not spec.submodule_search_locations:
        raise NoBackendError(f"there is no DDS: cyclonedds isn't installed; {_INSTALL} {_ELSEWHERE}")
    return next(iter(spec.submodule_search_locations))


def _names_in(folder: str) -> list[str]:
    # By os alone, because importing pathlib would take longer than the rest of this module.
    try:
        return [entry.name for entry in os.scandir(folder)]
    except OSError:
        return []
