"""KDL's geometry, without an installed KDL: vectors, rotations, frames, twists, wrenches. See docs/kdl.md."""

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
