"""Contexts: the state of the library from `init` to `shutdown`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.context.context import Context as Context

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.destroyable import DestroyableType as DestroyableType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DestroyableType="tfloom.node.values.destroyable",
    )
