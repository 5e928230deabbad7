"""Demonstration nodes for parameters."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from demo_nodes_py.parameters import async_param_client as async_param_client
    from demo_nodes_py.parameters import set_parameters_callback as set_parameters_callback
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        async_param_client="demo_nodes_py.parameters",
        set_parameters_callback="demo_nodes_py.parameters",
    )
