"""The private names that the classes of `launch` have in ROS, `node._Node__package`, for programs that read them.

Tests of launch files do, because launch gives no public name to most of what an action was constructed with.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar


class HasPrivateNames:
    """A class whose objects answer to `_Class__name` with what they keep as `_name`.

    Derived classes name the exceptions in `_other_names`: the private name in ROS, and the attribute here.
    """

    _other_names: ClassVar[Mapping[str, str]] = {}

    if not TYPE_CHECKING:  # or a type checker would take every attribute for one that is there

        def __getattr__(self, name: str) -> Any:
            owner, _, private = name.removeprefix("_").partition("__")
            for cls in type(self).__mro__ if private and name.startswith("_") else ():
                attribute = vars(cls).get("_other_names", {}).get(private, f"_{private}")
                if cls.__name__ == owner and attribute in vars(self):
                    return vars(self)[attribute]
            raise AttributeError(
                f"'{type(self).__name__}' object has no attribute '{name}'", name=name, obj=self
            )
