"""KDL's geometry, without an installed KDL: vectors, rotations, frames, twists, wrenches. See docs/kdl.md."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "Equal",
    "Frame",
    "Rotation",
    "SetToZero",
    "Twist",
    "Vector",
    "Wrench",
    "__getattr__",
    "__version__",
    "addDelta",
    "diff",
    "dot",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.kdl.absent import __getattr__ as __getattr__
    from tfloom.kdl.frames import Equal as Equal
    from tfloom.kdl.frames import Frame as Frame
    from tfloom.kdl.frames import Rotation as Rotation
    from tfloom.kdl.frames import SetToZero as SetToZero
    from tfloom.kdl.frames import Twist as Twist
    from tfloom.kdl.frames import Vector as Vector
    from tfloom.kdl.frames import Wrench as Wrench
    from tfloom.kdl.frames import __version__ as __version__
    from tfloom.kdl.frames import addDelta as addDelta
    from tfloom.kdl.frames import diff as diff
    from tfloom.kdl.frames import dot as dot
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Equal="tfloom.kdl.frames",
        Frame="tfloom.kdl.frames",
        Rotation="tfloom.kdl.frames",
        SetToZero="tfloom.kdl.frames",
        Twist="tfloom.kdl.frames",
        Vector="tfloom.kdl.frames",
        Wrench="tfloom.kdl.frames",
        __getattr__="tfloom.kdl.absent",
        __version__="tfloom.kdl.frames",
        addDelta="tfloom.kdl.frames",
        diff="tfloom.kdl.frames",
        dot="tfloom.kdl.frames",
    )
