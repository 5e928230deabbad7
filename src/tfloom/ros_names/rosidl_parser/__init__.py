"""Interface definitions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosidl_parser import definition as definition
    from rosidl_parser import parser as parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        definition="rosidl_parser",
        parser="rosidl_parser",
    )
