"""The search for eclipse-zenoh, the library of the Zenoh wire, and its log.

`import zenoh` costs a command time, so it is done when a session or a router is opened.
"""

from __future__ import annotations

import sys
from importlib.machinery import PathFinder
from types import ModuleType

from tfloom.rmw.errors import NoBackendError

__all__ = ["find_library", "open_library"]

_HOW_TO_INSTALL = "install it with: pip install 'tfloom[zenoh]'"
_HOW_TO_DO_WITHOUT = (
    "eclipse-zenoh has wheels for Linux with glibc, macOS and Windows; within one process, "
    "RMW_IMPLEMENTATION=tfloom_local needs nothing"
)


def find_library() -> str:
    """Return the folder of the package zenoh, without importing it.

    Raises:
        NoBackendError: it isn't installed.
    """
    spec = PathFinder.find_spec("zenoh")
    if spec is None or not spec.submodule_search_locations or spec.loader is None:
        raise NoBackendError(f"there is no Zenoh: {_HOW_TO_INSTALL}; {_HOW_TO_DO_WITHOUT}")
    return next(iter(spec.submodule_search_locations))


def open_library() -> ModuleType:
    """Return the module zenoh. Its log shows errors alone, unless RUST_LOG asks for more.

    Raises:
        NoBackendError: it isn't installed, or can't be loaded on this system.
    """
    is_first = "zenoh" not in sys.modules
    find_library()
    try:
        import zenoh
    except ImportError as error:
        raise NoBackendError(
            f"the package zenoh can't be loaded: {error}; {_HOW_TO_INSTALL}; {_HOW_TO_DO_WITHOUT}"
        ) from None
    if is_first:
        zenoh.init_log_from_env_or("off")
    return zenoh
