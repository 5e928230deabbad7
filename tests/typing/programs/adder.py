"""A service, its client and an action's client, as in rclpy programs."""

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient
from rclpy.node import Node


class Adder(Node):
    """Adds two integers, and calls its own service."""

    def __init__(self) -> None:
        super().__init__("adder")
        self.service = self.create_service(AddTwoInts, "add", self.add)
        self.client_ = self.create_client(AddTwoInts, "add")
        self.action_client = ActionClient(self, Fibonacci, "fibonacci")

    def add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        """Serve."""
        response.sum = request.a + request.b
        return response

    def ask(self) -> None:
        """Call."""
        request = AddTwoInts.Request(a=1)
        request.b = 2
        future = self.client_.call_async(request)
        rclpy.spin_until_future_complete(self, future)
        goal = Fibonacci.Goal(order=5)
        self.action_client.send_goal_async(goal)
