"""A node whose message, service and action exist in this process alone; with `lie`, it misdescribes the message."""

from __future__ import annotations

import sys
import time

import rclpy
from rclpy.action import ActionServer
from serving import serve

from tfloom.rosidl import sources
from tfloom.rosidl.dynamic import define

Part = define("lab_msgs/msg/Part", "string name\nuint8 count 1\n")
Sample = define("lab_msgs/msg/Sample", "std_msgs/Header header\nPart[<=2] parts\nfloat64[3] at\n")
Weigh = define("lab_msgs/srv/Weigh", "Part part\n---\nfloat32 grams\n")
Sort = define("lab_msgs/action/Sort", "Part[] parts\n---\nPart[] sorted\n---\nuint32 done\n")


def weigh(request: Weigh.Request, response: Weigh.Response) -> object:
    response.grams = 2.5 * request.part.count
    return response


def sort(goal_handle: object) -> object:
    end_s = time.monotonic() + 20
    while not node.count_subscribers("/sort/_action/feedback") and time.monotonic() < end_s:
        time.sleep(0.01)  # the goal may arrive before its client's subscription is discovered
    goal_handle.publish_feedback(Sort.Feedback(done=1))
    goal_handle.succeed()
    return Sort.Result(sorted=sorted(goal_handle.request.parts, key=lambda part: part.name))


rclpy.init()
node = rclpy.create_node("lab")
publisher = node.create_publisher(Sample, "/samples", 10)
node.create_timer(0.05, lambda: publisher.publish(Sample(at=[1.0, 2.0, 3.0])))
node.create_service(Weigh, "/weigh", weigh)
server = ActionServer(node, Sort, "/sort", sort)
if "lie" in sys.argv:
    sources.replace("lab_msgs/msg/Sample", sources.Source("float64[4] at", "a lie"))
serve(node)
