"""The search for libddsc, the shared library of Cyclone DDS 0.10 or 11, which implements DDS.

The places are searched in this order: the file that TFLOOM_LIBDDSC names; the distribution tfloom-ddsc; the wheel of
cyclonedds, whose package isn't imported; the system's libraries; a stock ROS 2 in /opt/ros.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from functools import lru_cache
from importlib.machinery import PathFinder
from typing import NamedTuple

from tfloom.common.terminal import report
from tfloom.rmw.errors import ForkedError, NoBackendError

__all__ = ["VARIABLE", "Library", "candidates", "find_library", "open_copy", "open_library"]

VARIABLE = "TFLOOM_LIBDDSC"
"""Names a libddsc in the environment, before all others."""

_WHEEL = "the wheel of cyclonedds"
_OWN = "tfloom-ddsc"
_PACKAGES = (
    (_OWN, "tfloom_ddsc", ".", re.compile(r"(lib)?ddsc[-.]")),
    (_WHEEL, "cyclonedds", "../cyclonedds.libs", re.compile(r".*ddsc[-.]")),  # on Linux and Windows
    (_WHEEL, "cyclonedds", ".dylibs", re.compile("libddsc")),  # on macOS
)
"""Each installed place: its name, the import package, a folder relative to that, and the names of libraries there."""

_SYSTEM_NAMES = re.compile(r"libddsc\.(so\.|\d*\.?dylib)")
_SYSTEM_FOLDERS = (
    "/usr/local/lib",
    f"/usr/lib/{getattr(sys.implementation, '_multiarch', '')}",  # of Debian and Ubuntu
    "/usr/lib64",
    "/usr/lib",
    "/opt/homebrew/lib",
)
_ROS_FOLDER = "/opt/ros"

_failures: dict[str, str] = {}
"""Why a library that was tried in this process can't be used, by its path."""


class Library(NamedTuple):
    """A libddsc that is open."""

    path: str
    version: str
    """`11.0.1`; empty if the library records none."""
    origin: str
    """The place where it was found, for messages: `the wheel of cyclonedds`."""
    passed_over: tuple[str, ...] = ()
    """The libraries before it that can't be used, each with the reason."""


def candidates() -> Iterator[tuple[str, str]]:
    """Yield the origin and the path of each libddsc of this machine, in the order in which they are tried.

    The file that TFLOOM_LIBDDSC names is yielded even if there is none.
    """
    if named := os.environ.get(VARIABLE):
        yield VARIABLE, named
    for origin, package, place, name in _PACKAGES:
        if folder := _package_folder(package):
            yield from ((origin, path) for path in _libraries_in(f"{folder}/{place}", name))
    for folder in _SYSTEM_FOLDERS:
        yield from (("the system", path) for path in _libraries_in(folder, _SYSTEM_NAMES))
    for distribution in _ros_distributions():
        for folder in (f"{distribution}/lib", *_subfolders(f"{distribution}/lib")):
            yield from ((f"ROS 2 in {distribution}", path) for path in _libraries_in(folder, _SYSTEM_NAMES))


def find_library() -> str:
    """Return the path of the first libddsc that is there, without opening it.

    Raises:
        NoBackendError: there is none.
    """
    for _, path in candidates():
        if os.path.isfile(path):  # importing pathlib would take longer than the rest of this module
            return path
    raise NoBackendError(f"there is no DDS: {_how_to_install()}")


def open_library() -> Library:
    """Open the first libddsc that can be used. Each passes a self-test of its interface before its first use.

    A library that can't be used is reported on stderr, once, if another one takes its place.

    Raises:
        NoBackendError: there is no libddsc, or none that can be opened, is version 0.10 or 11, and passes its test.
    """
    passed_over: list[str] = []
    is_new = False
    for origin, path in candidates():
        if path not in _failures:
            try:
                library = Library(path, _open(origin, path), origin, tuple(passed_over))
            except RuntimeError as error:
                _failures[path] = str(error)
                is_new = True
            else:
                if is_new:
                    for text in passed_over:
                        report(f"tfloom: {text}; {library.path} is used")
                return library
        passed_over.append(f"the DDS library of {origin} can't be used: {_failures[path]}")
    raise NoBackendError(f"{'; '.join(passed_over) or 'there is no DDS'}: {_how_to_install()}")


@lru_cache(maxsize=1)
def open_copy() -> Library:
    """Open a copy of libddsc in memory, for a process that was forked while its parent used the library.

    dlopen loads the copy as its own library. That one has neither the parent's participants nor locks that wait
    for the parent's threads.

    Raises:
        NoBackendError: as `open_library`.
        ForkedError: the system has no files in memory: it isn't Linux.
    """
    if sys.platform != "linux":
        raise ForkedError(
            "a process that was forked from one with a node can't use DDS on this system: start it by "
            "multiprocessing's method 'spawn', or fork before the first node is created"
        )
    from pathlib import Path

    original = open_library()
    # The descriptor stays open, so that a copy for a later fork has another name, by which dlopen distinguishes them.
    # The file's name holds the version where the library itself records none.
    copy = os.memfd_create(os.path.basename(original.path))
    with Path(original.path).open("rb") as library:
        while os.sendfile(copy, library.fileno(), None, 2**30):
            pass
    path = f"/proc/self/fd/{copy}"
    try:
        return original._replace(path=path, version=_open(original.origin, path))
    except RuntimeError as error:
        raise NoBackendError(f"a copy of {original.path} can't be used: {error}") from None


def _open(origin: str, path: str) -> str:
    """Open a library, and return its version.

    Raises:
        RuntimeError: it can't be used; the text has the reason.
    """
    from tfloom._native import open_dds_library

    # The builds of PyPI have been run by all tests, where the version is one of those; any other build is tested.
    return open_dds_library(path, is_common_build=origin in {_OWN, _WHEEL})


def _package_folder(package: str) -> str | None:
    spec = PathFinder.find_spec(package)
    if spec is None or not spec.submodule_search_locations:
        return None
    return next(iter(spec.submodule_search_locations))


def _libraries_in(folder: str, name: re.Pattern[str]) -> list[str]:
    """Return the libraries in a folder, each once, though links lead to it."""
    paths = [os.path.realpath(f"{folder}/{file}") for file in sorted(_names_in(folder)) if name.match(file)]
    return list(dict.fromkeys(paths))


def _ros_distributions() -> list[str]:
    """Return the folders of ROS 2's distributions: the sourced one first, then the newest."""
    sourced = os.environ.get("ROS_DISTRO")
    names = sorted(_names_in(_ROS_FOLDER), reverse=True)
    return [f"{_ROS_FOLDER}/{name}" for name in sorted(names, key=lambda name: name != sourced)]


def _subfolders(folder: str) -> list[str]:
    """Return the folder for this machine's libraries in that of a distribution's, if it is there."""
    multiarch = getattr(sys.implementation, "_multiarch", "")
    return [f"{folder}/{multiarch}"] if multiarch else []


def _names_in(folder: str) -> list[str]:
    # By os alone, because importing pathlib would take longer than the rest of this module.
    try:
        return [entry.name for entry in os.scandir(folder)]
    except OSError:
        return []


def _how_to_install() -> str:
    """Return how this Python gets a libddsc on this system."""
    import platform

    is_musl = "musl" in getattr(sys.implementation, "_multiarch", "")
    has_wheels = not is_musl and (sys.platform == "darwin" or platform.machine() in {"x86_64", "AMD64"})
    if has_wheels and sys.version_info < (3, 14):
        advice = "install one with: pip install 'cyclonedds>=11,<12'"
    elif has_wheels:
        advice = (
            "cyclonedds has no wheel for this Python, whose version doesn't matter to tfloom: pip install "
            "./packages/tfloom-ddsc, in tfloom's sources; or pip install --no-deps --target DIR --python-version 3.13 "
            "--only-binary=:all: cyclonedds==11.0.1, with DIR on PYTHONPATH"
        )
    elif is_musl:
        advice = f"PyPI has none for musl; {VARIABLE} names one that was built for it"
    else:
        advice = (
            "install the system's, by apt-get install libddsc0t64 (Debian 13, Ubuntu) or libddsc0debian (Debian 12), "
            f"or name one in {VARIABLE}"
        )
    return f"{advice}; within one process, RMW_IMPLEMENTATION=tfloom_local needs nothing"
