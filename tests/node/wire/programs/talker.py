"""Publishes on /chatter, as lines on stdin say, and prints its publisher's events.

JSON of QoSProfile's fields, durations in s, creates a publisher with that QoS, `leave` destroys it, a number publishes
that many messages, `assert` asserts its liveliness. Events are printed as JSON: the name and the status's fields.
"""

import json
import sys
import threading

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.executors import ExternalShutdownException
from rclpy.qos import QoSProfile
from std_msgs.msg import String


def say(text):
    sys.stdout.write(text + "\n")  # one write, because two threads print
    sys.stdout.flush()


def teller(name):
    def tell(status):
        say(json.dumps([name, {key: int(value) for key, value in status._asdict().items()}]))

    return tell


def qos_of(text):
    fields = json.loads(text)
    for name in ("deadline", "lifespan", "liveliness_lease_duration"):
        if name in fields:
            fields[name] = Duration(seconds=fields[name])
    return QoSProfile(**{"depth": 10, **fields})


def read_commands():
    publisher = None
    for line in sys.stdin:
        word = line.strip()
        if word.startswith("{"):
            publisher = node.create_publisher(String, "chatter", qos_of(word), event_callbacks=callbacks)
        elif word == "leave":
            node.destroy_publisher(publisher)
        elif word == "assert":
            publisher.assert_liveliness()
        else:
            for number in range(int(word)):
                publisher.publish(String(data=str(number)))
        say(f"did {word}")
    rclpy.try_shutdown()


rclpy.init()
node = rclpy.create_node("talker")
events = ("deadline", "liveliness", "matched")
callbacks = PublisherEventCallbacks(**{event: teller(event) for event in events})
say("ready")
threading.Thread(target=read_commands).start()
try:
    rclpy.spin(node)
except ExternalShutdownException:
    node.destroy_node()
