"""Demonstration nodes for services."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from demo_nodes_py.services import add_two_ints_client as add_two_ints_client
    from demo_nodes_py.services import add_two_ints_client_async as add_two_ints_client_async
    from demo_nodes_py.services import add_two_ints_server as add_two_ints_server
    from demo_nodes_py.services import introspection as introspection
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        add_two_ints_client="demo_nodes_py.services",
        add_two_ints_client_async="demo_nodes_py.services",
        add_two_ints_server="demo_nodes_py.services",
        introspection="demo_nodes_py.services",
    )
