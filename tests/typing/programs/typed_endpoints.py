"""What type checkers find out about messages that arrive, responses, goals, feedback and results."""

from typing import Any

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.action.client import ClientGoalHandle
from rclpy.action.server import ServerGoalHandle
from rclpy.client import Client
from rclpy.node import Node
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import SetBool
from typing_extensions import assert_type


class Typed(Node):
    """Has one endpoint of each kind, and bare names of generic classes in annotations."""

    any_client: Client
    any_service: Service
    any_subscription: Subscription
    any_action_client: ActionClient
    any_action_server: ActionServer

    def __init__(self) -> None:
        super().__init__("typed")
        self.switch = self.create_client(SetBool, "switch")
        self.switcher = self.create_service(SetBool, "switch", self.on_switch)
        self.adder = self.create_service(AddTwoInts, "add", self.on_add)
        self.fibonacci = ActionClient(self, Fibonacci, "fibonacci")
        self.server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            self.on_goal,
            goal_callback=self.on_goal_request,
            cancel_callback=lambda handle: CancelResponse.ACCEPT,
        )
        self.words = self.create_subscription(String, "words", self.on_word, 10)
        self.stamped = self.create_subscription(String, "words", self.on_word_and_info, 10)
        self.raw = self.create_subscription(String, "words", self.on_bytes, 10, raw=True)
        self.create_subscription(String, "words", lambda word: print(word.data), 10)
        self.any_client = self.switch
        self.any_service = self.switcher
        self.any_subscription = self.words
        self.any_action_client = self.fibonacci
        self.any_action_server = self.server

    def on_switch(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        """Serve at once."""
        response.success = request.data
        return response

    async def on_add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        """Serve by a coroutine, which awaits a client."""
        assert_type(await self.switch.call_async(SetBool.Request()), SetBool.Response | None)
        response.sum = request.a + request.b
        return response

    def on_word(self, message: String) -> None:
        """Take a message."""

    def on_word_and_info(self, message: String, info: dict[str, Any]) -> None:
        """Take a message and its stamps."""

    def on_bytes(self, data: bytes) -> None:
        """Take CDR."""

    def on_goal_request(self, goal: Fibonacci.Goal) -> GoalResponse:
        """Accept small numbers."""
        return GoalResponse.ACCEPT if goal.order < 50 else GoalResponse.REJECT

    async def on_goal(
        self, handle: ServerGoalHandle[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]
    ) -> Fibonacci.Result:
        """Execute."""
        assert_type(handle.request, Fibonacci.Goal)
        handle.publish_feedback(Fibonacci.Feedback(sequence=[0, 1]))
        handle.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1])

    def on_any_goal(self, handle: ServerGoalHandle) -> Fibonacci.Result:
        """Execute."""
        return Fibonacci.Result()

    def on_feedback(self, message: Fibonacci.Impl.FeedbackMessage) -> None:
        """Take feedback."""
        assert_type(message.feedback, Fibonacci.Feedback)

    def ask(self) -> None:
        """Call the service, both ways."""
        assert_type(self.switch, Client[SetBool.Request, SetBool.Response])
        future = self.switch.call_async(SetBool.Request(data=True))
        assert_type(future, Future[SetBool.Response])
        response = self.switch.call(SetBool.Request(data=False), timeout_sec=1.0)
        assert_type(response, SetBool.Response | None)
        if response is not None:
            assert_type(response.success, bool)
        assert_type(self.words, Subscription[String])
        self.switch.srv_type.Request(data=True)

    async def pursue(self) -> None:
        """Send a goal and wait for its result."""
        goal = Fibonacci.Goal(order=5)
        handle = await self.fibonacci.send_goal_async(goal, feedback_callback=self.on_feedback)
        if handle is None or not handle.accepted:
            return
        bare: ClientGoalHandle = handle
        print(bare.goal_id)
        ended = await handle.get_result_async()
        if ended is not None:
            assert_type(ended.result, Fibonacci.Result)
            assert_type(ended.status, int)
        self.server.register_execute_callback(self.on_any_goal)
