"""Time: a point in time on one clock."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.time import S_TO_NS as S_TO_NS
from tfloom.node.values.time import Time as Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.clock_type import ClockType as ClockType
    from tfloom.node.values.duration import Duration as Duration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ClockType="tfloom.node.values.clock_type",
        Duration="tfloom.node.values.duration",
    )
