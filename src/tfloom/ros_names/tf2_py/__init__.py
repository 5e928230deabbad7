"""The buffer and its exceptions, without a node."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("tf2_py")

__all__ = [
    "BackwardExtrapolationException",
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "ForwardExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "NoDataForExtrapolationException",
    "TimeoutException",
    "TransformException",
    "add_dll_directories_from_env",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
    from tfloom.tf2.errors import BackwardExtrapolationException as BackwardExtrapolationException
    from tfloom.tf2.errors import ConnectivityException as ConnectivityException
    from tfloom.tf2.errors import ExtrapolationException as ExtrapolationException
    from tfloom.tf2.errors import ForwardExtrapolationException as ForwardExtrapolationException
    from tfloom.tf2.errors import InvalidArgumentException as InvalidArgumentException
    from tfloom.tf2.errors import LookupException as LookupException
    from tfloom.tf2.errors import NoDataForExtrapolationException as NoDataForExtrapolationException
    from tfloom.tf2.errors import TimeoutException as TimeoutException
    from tfloom.tf2.errors import TransformException as TransformException
    from tfloom.tf2_ros.buffer_core import BufferCore as BufferCore
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        BackwardExtrapolationException="tfloom.tf2.errors",
        BufferCore="tfloom.tf2_ros.buffer_core",
        ConnectivityException="tfloom.tf2.errors",
        ExtrapolationException="tfloom.tf2.errors",
        ForwardExtrapolationException="tfloom.tf2.errors",
        InvalidArgumentException="tfloom.tf2.errors",
        LookupException="tfloom.tf2.errors",
        NoDataForExtrapolationException="tfloom.tf2.errors",
        TimeoutException="tfloom.tf2.errors",
        TransformException="tfloom.tf2.errors",
        add_dll_directories_from_env="tfloom.c_libraries",
    )
