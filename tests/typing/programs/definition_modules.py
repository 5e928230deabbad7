"""Imports from the modules of definitions, as editors insert them."""

from example_interfaces.action._fibonacci import Fibonacci, Fibonacci_GetResult_Request
from geometry_msgs.msg._twist import Metaclass_Twist, Twist
from std_srvs.srv._set_bool import SetBool, SetBool_Response


def switch(request: SetBool.Request, response: SetBool_Response) -> SetBool.Response:
    response.success = request.data
    return response


def speed(twist: Twist) -> float:
    return twist.linear.x


def order(goal: Fibonacci.Goal, request: Fibonacci_GetResult_Request) -> tuple[int, int]:
    return goal.order, len(request.goal_id.uuid)


NAMES: list[type[type]] = [Metaclass_Twist]
