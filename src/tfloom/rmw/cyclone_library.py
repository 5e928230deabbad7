"""Where libddsc is: in the wheel of cyclonedds, found without importing that package."""

from __future__ import annotations

from importlib.machinery import PathFinder
from pathlib import Path

from tfloom.rmw.errors import NoBackendError

SUPPORTED_MAJOR = 11

_INSTALL = "install it with: pip install 'cyclonedds>=11,<12'"
_ELSEWHERE = (
    "(it has wheels for Python 3.10 to 3.13 on Linux x86_64, macOS and Windows); "
    "within one process, RMW_IMPLEMENTATION=tfloom_local needs nothing"
)


def find_library() -> str:
    """Return the path of libddsc.

    Raises:
        NoBackendError: cyclonedds isn't installed, isn't version 11, or came without its library.
    """
    package = _find_package()
    _check_version(package)
    for pattern in ("../cyclonedds.libs/*ddsc[-.]*", ".dylibs/libddsc*"):
        if found := sorted(package.glob(pattern)):
            return str(found[0].resolve())
    raise NoBackendError(
        f"cyclonedds in {package} came without libddsc: it wasn't installed from a wheel; {_INSTALL}"
    )


def _find_package() -> Path:
    spec = PathFinder.find_spec("cyclonedds")
    if spec is None or not spec.submodule_search_locations:
        raise NoBackendError(f"there is no DDS: cyclonedds isn't installed; {_INSTALL} {_ELSEWHERE}")
    return Path(next(iter(spec.submodule_search_locations)))


def _check_version(package: Path) -> None:
    for metadata in package.parent.glob("cyclonedds-*.dist-info"):
        version = metadata.name.removeprefix("cyclonedds-").removesuffix(".dist-info")
        if version.partition(".")[0] != str(SUPPORTED_MAJOR):
            raise NoBackendError(f"cyclonedds {version} in {package} can't be used; {_INSTALL}")
