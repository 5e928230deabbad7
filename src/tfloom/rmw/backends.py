"""Selection of the wire by RMW_IMPLEMENTATION; its backend is imported when it is selected."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from typing import TYPE_CHECKING

from tfloom.common.terminal import report
from tfloom.rmw.errors import ConfigurationError, NoBackendError

if TYPE_CHECKING:
    from tfloom.rmw.base import Participant

BACKENDS = {
    "rmw_cyclonedds_cpp": "tfloom.rmw.cyclone.wire",
    "rmw_zenoh_cpp": "tfloom.rmw.zenoh.wire",
    "tfloom_local": "tfloom.rmw.local.wire",
}
"""ROS's name of each wire, and the module that implements it."""

LIBRARIES = {
    "rmw_cyclonedds_cpp": "tfloom.rmw.cyclone.library",
    "rmw_zenoh_cpp": "tfloom.rmw.zenoh.library",
}
"""The module whose `find_library` locates the library of a wire; other wires need none."""

STAND_INS = {
    "rmw_fastrtps_cpp": "rmw_cyclonedds_cpp",
    "rmw_fastrtps_dynamic_cpp": "rmw_cyclonedds_cpp",
}
"""Wires that are not implemented, and the interoperable one that is used instead."""

TRANSLATING_PROCESSORS = ("x86_64", "aarch64")
"""The processors of Linux on which services pass between libddsc and Fast DDS; see `native/core/imports.cpp`."""

DEFAULT = "rmw_cyclonedds_cpp"
WITHOUT_DDS = "rmw_zenoh_cpp"
"""The wire that nobody has to select where there is no DDS library, if its own is installed."""
MAX_DOMAIN_ID = 232

_reported_replacements: set[str] = set()


def open_participant(domain_id: int | None = None, enclave: str = "/") -> Participant:
    """Join a domain on the wire that RMW_IMPLEMENTATION names.

    Args:
        domain_id: 0 to 232; None takes ROS_DOMAIN_ID, or 0 where it isn't set.
        enclave: Security enclave to announce.

    Raises:
        ConfigurationError: the domain isn't an integer from 0 to 232, or another setting is invalid for the wire.
        NoBackendError: RMW_IMPLEMENTATION names no known wire, or the wire's library isn't installed.
    """
    module = import_module(BACKENDS[implementation_identifier()])
    domain = domain_id_from_environment() if domain_id is None else _checked(domain_id, "domain_id")
    participant: Participant = module.open_participant(domain, enclave)
    return participant


def implementation_identifier() -> str:
    """Return the wire in use, a key of `BACKENDS`.

    Raises:
        NoBackendError: RMW_IMPLEMENTATION names no known wire.
    """
    asked = os.environ.get("RMW_IMPLEMENTATION") or _default()
    name = STAND_INS.get(asked, asked)
    if name not in BACKENDS:
        known_names = ", ".join([*BACKENDS, *STAND_INS])
        raise NoBackendError(f"RMW_IMPLEMENTATION is {asked!r}, which is none of: {known_names}")
    if name != asked and asked not in _reported_replacements:
        _reported_replacements.add(asked)
        passing = (
            f"topics pass between the two, services don't, because {why}"
            if (why := _untranslated())
            else ("topics and services pass between the two")
        )
        report(f"tfloom: {asked} isn't available, so {name} is used: {passing}")
    return name


def _default() -> str:
    """Return the wire where RMW_IMPLEMENTATION is not set; say once if it isn't the usual one."""
    if is_installed(DEFAULT) or not is_installed(WITHOUT_DDS):
        return DEFAULT
    if DEFAULT not in _reported_replacements:
        _reported_replacements.add(DEFAULT)
        report(f"tfloom: there is no DDS library, so {WITHOUT_DDS} is used, because Zenoh is installed")
    return WITHOUT_DDS


def _untranslated() -> str:
    """Return why services don't pass with Fast DDS, as far as it is known before the wire's library is loaded."""
    from tfloom.rmw.cyclone.services import TRANSLATION_VARIABLE

    if os.environ.get(TRANSLATION_VARIABLE) == "0":
        return f"{TRANSLATION_VARIABLE} is 0"
    if sys.platform != "linux":
        return "they are translated on Linux only"
    if (processor := os.uname().machine) not in TRANSLATING_PROCESSORS:
        return f"they are translated on {' and '.join(TRANSLATING_PROCESSORS)} only, and this is {processor}"
    return ""


def is_installed(name: str) -> bool:
    """Return whether the library of a wire is installed, in whichever version, without loading it.

    Args:
        name: The wire, a key of `BACKENDS`.
    """
    if name not in LIBRARIES:
        return True
    try:
        import_module(LIBRARIES[name]).find_library()
    except NoBackendError:
        return False
    return True


def domain_id_from_environment() -> int:
    """Return ROS_DOMAIN_ID, or 0 where it isn't set.

    Raises:
        ConfigurationError: it isn't an integer from 0 to 232.
    """
    text = os.environ.get("ROS_DOMAIN_ID", "").strip()
    if not text:
        return 0
    try:
        return _checked(int(text), "ROS_DOMAIN_ID")
    except ValueError:
        raise ConfigurationError(_domain_text("ROS_DOMAIN_ID", text)) from None


def _checked(domain_id: int, where: str) -> int:
    if not 0 <= domain_id <= MAX_DOMAIN_ID:
        raise ConfigurationError(_domain_text(where, domain_id))
    return domain_id


def _domain_text(where: str, domain_value: object) -> str:
    return f"{where} must be an integer from 0 to {MAX_DOMAIN_ID}, not {domain_value!r}"
