"""Demonstration nodes: topics, services, parameters, logging and events."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("demo_nodes_py")

TYPE_CHECKING = False
if TYPE_CHECKING:
    from demo_nodes_py import events as events
    from demo_nodes_py import logging as logging
    from demo_nodes_py import parameters as parameters
    from demo_nodes_py import services as services
    from demo_nodes_py import topics as topics
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        events="demo_nodes_py",
        logging="demo_nodes_py",
        parameters="demo_nodes_py",
        services="demo_nodes_py",
        topics="demo_nodes_py",
    )
