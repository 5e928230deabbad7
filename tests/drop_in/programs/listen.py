"""Listen with the drop-in listener in the real rclpy, and answer queries.

Arguments: raw, reader or nothing; a domain or nothing; arguments of ROS.

A line of input is [target, source, timeout in s]. The answer is JSON: translation x and stamp; or an error.
"""

from __future__ import annotations

import json
import sys
import threading
from contextlib import suppress

import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.time import Time

from tfloom.drop_in import Buffer, TransformException, TransformListener


def main() -> None:
    raw, domain, *arguments = sys.argv[1:]
    rclpy.init(args=arguments, domain_id=int(domain) if domain else None)
    node = rclpy.create_node("under_test", namespace="/robot")
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node, raw={"": None, "raw": True, "reader": False}[raw])
    executor = SingleThreadedExecutor()
    executor.add_node(node)

    def spin() -> None:
        with suppress(ExternalShutdownException):
            executor.spin()

    thread = threading.Thread(target=spin)
    thread.start()
    print(f"ready: {listener.why_raw!r}", flush=True)
    for line in sys.stdin:
        target, source, timeout_s = json.loads(line)
        try:
            transform = buffer.lookup_transform(target, source, Time(), Duration(seconds=timeout_s))
        except TransformException as error:
            answer = {"error": f"{type(error).__name__}: {error}"}
        else:
            stamp_ns = Time.from_msg(transform.header.stamp).nanoseconds
            answer = {"x": transform.transform.translation.x, "stamp_ns": stamp_ns}
        print(json.dumps(answer | {"why_raw": listener.why_raw}), flush=True)
    rclpy.shutdown()
    thread.join()
    print("ended", flush=True)


if __name__ == "__main__":
    main()
