"""The services that the recorded commands called: /spawn accepts each name once, /clear does nothing."""

from __future__ import annotations

import rclpy
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from serving import serve
from std_srvs.srv import Empty
from turtlesim.srv import Spawn

names: set[str] = set()


def spawn(request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
    if request.name not in names:
        names.add(request.name)
        response.name = request.name
    return response


rclpy.init()
node = rclpy.create_node("turtlesim")
service = node.create_service(Spawn, "/spawn", spawn)
service.configure_introspection(
    node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
)
node.create_service(Empty, "/clear", lambda _, response: response)
node.create_client(Empty, "/reset")
serve(node)
