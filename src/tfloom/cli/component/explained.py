"""The common output of the verbs that need C++."""

from __future__ import annotations

from tfloom.cli.errors import CommandError


def needs_cpp() -> CommandError:
    """Return the error that says why there are no components here."""
    return CommandError(
        "Components are C++ libraries that a C++ container loads; tfloom runs Python nodes, each by `run`. "
        "`component list`, `load` and `unload` work with the containers that others run on the domain"
    )
