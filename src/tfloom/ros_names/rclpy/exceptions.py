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
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.context.arguments import RCLInvalidROSArgsError as RCLInvalidROSArgsError
from tfloom.node.context.arguments import UnknownROSArgsError as UnknownROSArgsError
from tfloom.node.parameters.exceptions import InvalidParameterException as InvalidParameterException
from tfloom.node.parameters.exceptions import InvalidParameterTypeException as InvalidParameterTypeException
from tfloom.node.parameters.exceptions import InvalidParameterValueException as InvalidParameterValueException
from tfloom.node.parameters.exceptions import ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException
from tfloom.node.parameters.exceptions import ParameterException as ParameterException
from tfloom.node.parameters.exceptions import ParameterImmutableException as ParameterImmutableException
from tfloom.node.parameters.exceptions import ParameterNotDeclaredException as ParameterNotDeclaredException
from tfloom.node.parameters.exceptions import ParameterUninitializedException as ParameterUninitializedException
from tfloom.node.values.exceptions import NoTypeSupportImportedException as NoTypeSupportImportedException
from tfloom.node.values.exceptions import NodeNameNonExistentError as NodeNameNonExistentError
from tfloom.node.values.exceptions import NotInitializedException as NotInitializedException
from tfloom.node.values.exceptions import RCLError as RCLError
from tfloom.node.values.exceptions import ROSInterruptException as ROSInterruptException
from tfloom.node.values.exceptions import TimerCancelledError as TimerCancelledError
from tfloom.node.values.names import InvalidNamespaceException as InvalidNamespaceException
from tfloom.node.values.names import InvalidNodeNameException as InvalidNodeNameException
from tfloom.node.values.names import InvalidServiceNameException as InvalidServiceNameException
from tfloom.node.values.names import InvalidTopicNameException as InvalidTopicNameException
from tfloom.node.values.names import NameValidationException as NameValidationException

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidHandle="tfloom.node.values.exceptions",
    )
