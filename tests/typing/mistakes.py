"""Each line that ends in `# mistake` is one for mypy and for pyright, and no other is."""

from example_interfaces.action import Fibonacci
from geometry_msgs.msg import Twist, Vector3
from rclpy.action import ActionClient, ActionServer
from rclpy.action.server import ServerGoalHandle
from rclpy.node import Node
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, Trigger
from turtlesim.srv import Spawn


class Mistaken(Node):
    def __init__(self) -> None:
        super().__init__("mistaken")
        self.client = self.create_client(SetBool, "switch")
        self.fibonacci = ActionClient(self, Fibonacci, "fibonacci")

    def of_messages(self) -> None:
        twist = Twist(linear=3)  # mistake
        twist.linear.q = 1.0  # mistake
        twist.linear.x = "abc"  # mistake
        Vector3(1.0, 2.0, 3.0)  # mistake
        String(dta="x")  # mistake
        number: int = String().data  # mistake
        print(number)
        Spawn.Request(x="1")  # mistake

    def of_topics(self) -> None:
        self.create_subscription(String, "word", self.on_number, 10)  # mistake
        self.create_publisher(String, "word", 10).publish(Int32())  # mistake

    def of_services(self) -> None:
        self.create_service(SetBool, "switch", self.on_trigger)  # mistake
        self.client.call_async(Trigger.Request())  # mistake
        response = self.client.call(SetBool.Request(data=True))
        if response is not None:
            print(response.sucess)  # mistake
        print(self.client.call_async(SetBool.Request(date=True)))  # mistake
        SetBool.Reqest()  # mistake

    async def of_actions(self) -> None:
        self.fibonacci.send_goal_async(Fibonacci.Result())  # mistake
        self.fibonacci.send_goal_async(Fibonacci.Goal(), feedback_callback=self.on_number)  # mistake
        handle = await self.fibonacci.send_goal_async(Fibonacci.Goal())
        ended = await handle.get_result_async()
        print(ended.result.sequense)  # mistake
        ActionServer(self, Fibonacci, "fibonacci", self.on_goal)  # mistake

    def on_number(self, message: Int32) -> None: ...

    def on_trigger(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        return response

    def on_goal(
        self, handle: ServerGoalHandle[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]
    ) -> Fibonacci.Goal:
        handle.publish_feedback(Fibonacci.Result())  # mistake
        return handle.request
