"""What rclpy raises.

Exception
├── NotInitializedException             a context was used before init or after shutdown
├── ROSInterruptException               shutdown came during a sleep
├── NoTypeSupportImportedException      a class that is no message was given as a type
├── InvalidHandle                       something was used after its destroy
├── NameValidationException             a name that ROS doesn't allow: which, why, and where in it
│   ├── InvalidNamespaceException
│   ├── InvalidNodeNameException
│   ├── InvalidTopicNameException
│   └── InvalidServiceNameException
├── ParameterException
│   ├── ParameterNotDeclaredException
│   ├── ParameterAlreadyDeclaredException
│   ├── InvalidParameterException       its name isn't valid
│   ├── InvalidParameterTypeException
│   ├── InvalidParameterValueException
│   ├── ParameterImmutableException
│   └── ParameterUninitializedException
└── RuntimeError
    ├── UnknownROSArgsError             something behind --ros-args is no ROS argument
    └── RCLError
        ├── RCLInvalidROSArgsError      an argument behind --ros-args can't be understood
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
