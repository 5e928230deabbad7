"""A node of zenoh-ros2-sdk, in its own environment: talks and listens, serves and calls.

It gets the port of the router, and prints what it hears, is asked, and is answered.
"""

from __future__ import annotations

import os
import sys

from zenoh_ros2_sdk import (
    ROS2Publisher,
    ROS2ServiceClient,
    ROS2ServiceServer,
    ROS2Subscriber,
)

TYPE, DEFINITION = "std_msgs/msg/String", "string data\n"
SERVICE, REQUEST, RESPONSE = "example_interfaces/srv/AddTwoInts", "int64 a\nint64 b\n", "int64 sum\n"


def main() -> None:
    place = {
        "router_port": int(sys.argv[1]),
        "domain_id": int(os.environ["ROS_DOMAIN_ID"]),
        "node_name": "witness",
        "namespace": "/far",
    }
    hashes = dict(zip(("topic", "service"), sys.argv[2:4], strict=True))
    subscriber = ROS2Subscriber(
        "/to_witness",
        TYPE,
        lambda message: print("heard", message.data, flush=True),
        msg_definition=DEFINITION,
        type_hash=hashes["topic"],
        **place,
    )
    publisher = ROS2Publisher(
        "/from_witness", TYPE, msg_definition=DEFINITION, type_hash=hashes["topic"], **place
    )
    services = {
        "request_definition": REQUEST,
        "response_definition": RESPONSE,
        "type_hash": hashes["service"],
        **place,
    }

    def add(request: object) -> object:
        print("asked", request.a, request.b, flush=True)
        return server.response_msg_class(sum=request.a + request.b)

    server = ROS2ServiceServer("/far/add", SERVICE, add, **services)
    client = ROS2ServiceClient("/near/add", SERVICE, **services)
    print("ready", flush=True)
    number = 0
    for line in sys.stdin:
        if line.strip() == "call":
            response = client.call(a=20, b=22)
            print("answered", response and response.sum, flush=True)
        else:
            number += 1
            publisher.publish(data=f"witness {number}")
    for end in (subscriber, publisher, server, client):
        end.close()


main()
