"""What `rosidl_generator_py` has here: nothing, with a hint, because message classes need no generated code."""

from __future__ import annotations

from typing import NoReturn

__all__ = ["__getattr__"]


def __getattr__(name: str) -> NoReturn:  # for `from rosidl_generator_py import name`
    """Raise an ImportError with what to use instead; for the names that Python looks for itself, an AttributeError."""
    if name.startswith("__"):
        raise AttributeError(f"module 'rosidl_generator_py' has no attribute {name!r}")
    raise ImportError(
        f"'rosidl_generator_py.{name}' isn't part of tfloom, which generates no code for interface packages: "
        "import their classes (`from my_interfaces.msg import X`), or write typed modules for editors with "
        "`tfloom interfaces stubs DIR`.",
        name="rosidl_generator_py",
    )
