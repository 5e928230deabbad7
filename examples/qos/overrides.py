"""Let parameters override the quality of service of a publisher and a subscription, within limits.

On the command line, or in a file (`--ros-args --params-file examples/qos/overrides.yaml`):
`-p qos_overrides./frames.publisher.reliability:=best_effort`
"""

from __future__ import annotations

import sys

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions
from std_msgs.msg import String

POLICIES = (QoSPolicyKind.RELIABILITY, QoSPolicyKind.DURABILITY, QoSPolicyKind.DEPTH)
MOST_FRAMES = 100


def check(profile: QoSProfile) -> SetParametersResult:
    """Accept a profile unless it needs too much memory."""
    accepted = profile.depth <= MOST_FRAMES
    return SetParametersResult(
        successful=accepted, reason="" if accepted else f"more than {MOST_FRAMES} frames"
    )


class Camera(Node):
    """Publishes frames and receives them again, each with the profile that the parameters leave."""

    def __init__(self) -> None:
        super().__init__("camera")
        self.publisher = self.create_publisher(
            String, "frames", 10, qos_overriding_options=QoSOverridingOptions(POLICIES, callback=check)
        )
        self.subscription = self.create_subscription(
            String,
            "frames",
            self.on_frame,
            10,
            qos_overriding_options=QoSOverridingOptions.with_default_policies(
                callback=check, entity_id="viewer"
            ),
        )
        for name in sorted(self.get_parameters_by_prefix("qos_overrides")):
            value = self.get_parameter(f"qos_overrides.{name}").value
            self.get_logger().info(f"{name} = {value}")
        self.timer = self.create_timer(0.2, lambda: self.publisher.publish(String(data="a frame")))

    def on_frame(self, message: String) -> None:
        self.get_logger().info(f"Seen {message.data}", once=True)


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        rclpy.spin(Camera())
    except InvalidQosOverridesError as error:
        print(f"The camera doesn't start: {error}", file=sys.stderr)
        return 1
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
    return 0


if __name__ == "__main__":
    sys.exit(main())
