"""Validation of parameter names."""

from __future__ import annotations

from tfloom.node.parameters.exceptions import InvalidParameterException

__all__ = ["validate_parameter_name"]


def validate_parameter_name(name: str) -> bool:
    """Return True for a valid parameter name: any text that isn't empty.

    Raises:
        InvalidParameterException: it is empty.
    """
    if not name:
        raise InvalidParameterException(name)
    return True
