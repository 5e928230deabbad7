"""The services of a node with a lifecycle of two states: unconfigured and inactive."""

from __future__ import annotations

import rclpy
from lifecycle_msgs.msg import State, Transition, TransitionDescription
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from serving import serve

UNCONFIGURED, INACTIVE = State(id=1, label="unconfigured"), State(id=2, label="inactive")
CONFIGURE = TransitionDescription(
    transition=Transition(id=1, label="configure"), start_state=UNCONFIGURED, goal_state=INACTIVE
)
CLEANUP = TransitionDescription(
    transition=Transition(id=2, label="cleanup"), start_state=INACTIVE, goal_state=UNCONFIGURED
)
state = UNCONFIGURED


def get_state(_: GetState.Request, response: GetState.Response) -> object:
    response.current_state = state
    return response


def get_transitions(_: GetAvailableTransitions.Request, response: GetAvailableTransitions.Response) -> object:
    response.available_transitions = [CONFIGURE if state is UNCONFIGURED else CLEANUP]
    return response


def get_graph(_: GetAvailableTransitions.Request, response: GetAvailableTransitions.Response) -> object:
    response.available_transitions = [CONFIGURE, CLEANUP]
    return response


def change_state(request: ChangeState.Request, response: ChangeState.Response) -> object:
    global state  # noqa: PLW0603
    state = INACTIVE if request.transition.id == 1 else UNCONFIGURED
    response.success = True
    return response


rclpy.init()
node = rclpy.create_node("a_node")
node.create_service(GetState, "~/get_state", get_state)
node.create_service(GetAvailableTransitions, "~/get_available_transitions", get_transitions)
node.create_service(GetAvailableTransitions, "~/get_transition_graph", get_graph)
node.create_service(ChangeState, "~/change_state", change_state)
serve(node)
