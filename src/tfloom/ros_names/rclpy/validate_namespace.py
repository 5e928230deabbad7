"""Validation of namespaces."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.names import validate_namespace as validate_namespace

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.names import InvalidNamespaceException as InvalidNamespaceException
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidNamespaceException="tfloom.node.values.names",
    )
