"""The exceptions of rclpy.

Exception
├── NotInitializedException             a context is used before init or after shutdown
├── ROSInterruptException               the context is shut down during a sleep
├── NoTypeSupportImportedException      kept for programs that catch it; never raised
├── ValueError
│   └── NameValidationException         a name is not valid: which, why, and at which character
│       ├── InvalidNamespaceException
│       ├── InvalidNodeNameException
│       ├── InvalidTopicNameException
│       └── InvalidServiceNameException
├── ParameterException
│   ├── ParameterNotDeclaredException
│   ├── ParameterAlreadyDeclaredException
│   ├── InvalidParameterException       the name is empty
│   ├── InvalidParameterTypeException
│   ├── InvalidParameterValueException
│   ├── ParameterImmutableException
│   └── ParameterUninitializedException
└── RuntimeError
    ├── InvalidHandle                   an object is used after it was destroyed
    ├── UnknownROSArgsError             an argument after --ros-args is not a ROS argument
    └── RCLError
        ├── RCLInvalidROSArgsError      an argument after --ros-args is malformed
        ├── NodeNameNonExistentError
        └── TimerCancelledError
"""

from tfloom.node.context.arguments import RCLInvalidROSArgsError, UnknownROSArgsError
from tfloom.node.parameters.exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from tfloom.node.values.exceptions import (
    InvalidHandle,
    NodeNameNonExistentError,
    NotInitializedException,
    NoTypeSupportImportedException,
    RCLError,
    ROSInterruptException,
    TimerCancelledError,
)
from tfloom.node.values.names import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NameValidationException,
)

__all__ = [
    "InvalidHandle",
    "InvalidNamespaceException",
    "InvalidNodeNameException",
    "InvalidParameterException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "NameValidationException",
    "NoTypeSupportImportedException",
    "NodeNameNonExistentError",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterException",
    "ParameterImmutableException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
    "RCLError",
    "RCLInvalidROSArgsError",
    "ROSInterruptException",
    "TimerCancelledError",
    "UnknownROSArgsError",
]
