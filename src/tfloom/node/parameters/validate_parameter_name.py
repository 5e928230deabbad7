"""What is valid as a parameter's name."""

from __future__ import annotations

from tfloom.node.parameters.exceptions import InvalidParameterException

__all__ = ["validate_parameter_name"]


def validate_parameter_name(name: str) -> bool:
    """Return True for a valid name of a parameter: any text that isn't empty.

    Raises:
        InvalidParameterException: it is empty.
    """
    if not name:
        raise InvalidParameterException(name)
    return True
