"""The type variables of endpoints and actions. Each has the default Any, so that `Client` alone is a complete type."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, Any

from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Service

if TYPE_CHECKING:
    from typing_extensions import TypeVar
else:

    def TypeVar(name: str, *, bound: object = None, **_: object) -> typing.TypeVar:  # noqa: N802  # typing_extensions' name
        """Make a type variable without its default, which `typing.TypeVar` does not take before Python 3.13."""
        return typing.TypeVar(name, bound=bound)


MsgType = TypeVar("MsgType", bound=Message, default=Any)
SrvType = TypeVar("SrvType", bound=Service, default=Any)
SrvTypeRequest = TypeVar("SrvTypeRequest", default=Any)
SrvTypeResponse = TypeVar("SrvTypeResponse", default=Any)
GoalT = TypeVar("GoalT", default=Any)
ResultT = TypeVar("ResultT", default=Any)
FeedbackT = TypeVar("FeedbackT", default=Any)
FeedbackMessageT = TypeVar("FeedbackMessageT", default=Any)
"""The message that carries feedback, with `.goal_id` and `.feedback`."""
ResultResponseT = TypeVar("ResultResponseT", default=Any)
"""The response that carries a result, with `.status` and `.result`."""
