"""Calls /add many times from many clients at once, and checks that each response belongs to its request."""

import sys

import rclpy
from example_interfaces.srv import AddTwoInts

number, clients, rounds = map(int, sys.argv[1:])
rclpy.init()
node = rclpy.create_node(f"caller_{number}")
ends = [node.create_client(AddTwoInts, "add") for _ in range(clients)]
print("ready", flush=True)
sys.stdin.readline()
for end in ends:
    assert end.wait_for_service(timeout_sec=30)
for turn in range(rounds):
    asked = [AddTwoInts.Request(a=1_000_000 * number + 1000 * i, b=turn) for i in range(clients)]
    futures = [end.call_async(request) for end, request in zip(ends, asked, strict=True)]
    for future, request in zip(futures, asked, strict=True):
        rclpy.spin_until_future_complete(node, future, timeout_sec=30)
        assert future.result().sum == request.a + request.b, (request, future.result())
print(f"right: {rounds * clients}", flush=True)
node.destroy_node()
rclpy.shutdown()
