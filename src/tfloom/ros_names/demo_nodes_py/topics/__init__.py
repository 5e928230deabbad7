"""Demonstration nodes for topics."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from demo_nodes_py.topics import listener as listener
    from demo_nodes_py.topics import listener_qos as listener_qos
    from demo_nodes_py.topics import listener_serialized as listener_serialized
    from demo_nodes_py.topics import talker as talker
    from demo_nodes_py.topics import talker_qos as talker_qos
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        listener="demo_nodes_py.topics",
        listener_qos="demo_nodes_py.topics",
        listener_serialized="demo_nodes_py.topics",
        talker="demo_nodes_py.topics",
        talker_qos="demo_nodes_py.topics",
    )
