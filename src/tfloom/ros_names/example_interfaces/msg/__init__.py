"""The messages of example_interfaces."""

from tfloom.interfaces.example_interfaces.msg import *
from tfloom.interfaces.example_interfaces.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from example_interfaces.msg import _bool as _bool
    from example_interfaces.msg import _byte as _byte
    from example_interfaces.msg import _byte_multi_array as _byte_multi_array
    from example_interfaces.msg import _char as _char
    from example_interfaces.msg import _empty as _empty
    from example_interfaces.msg import _float32 as _float32
    from example_interfaces.msg import _float32_multi_array as _float32_multi_array
    from example_interfaces.msg import _float64 as _float64
    from example_interfaces.msg import _float64_multi_array as _float64_multi_array
    from example_interfaces.msg import _int16 as _int16
    from example_interfaces.msg import _int16_multi_array as _int16_multi_array
    from example_interfaces.msg import _int32 as _int32
    from example_interfaces.msg import _int32_multi_array as _int32_multi_array
    from example_interfaces.msg import _int64 as _int64
    from example_interfaces.msg import _int64_multi_array as _int64_multi_array
    from example_interfaces.msg import _int8 as _int8
    from example_interfaces.msg import _int8_multi_array as _int8_multi_array
    from example_interfaces.msg import _multi_array_dimension as _multi_array_dimension
    from example_interfaces.msg import _multi_array_layout as _multi_array_layout
    from example_interfaces.msg import _string as _string
    from example_interfaces.msg import _u_int16 as _u_int16
    from example_interfaces.msg import _u_int16_multi_array as _u_int16_multi_array
    from example_interfaces.msg import _u_int32 as _u_int32
    from example_interfaces.msg import _u_int32_multi_array as _u_int32_multi_array
    from example_interfaces.msg import _u_int64 as _u_int64
    from example_interfaces.msg import _u_int64_multi_array as _u_int64_multi_array
    from example_interfaces.msg import _u_int8 as _u_int8
    from example_interfaces.msg import _u_int8_multi_array as _u_int8_multi_array
    from example_interfaces.msg import _w_string as _w_string
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("example_interfaces.msg")
