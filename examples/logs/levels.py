"""Log with five severities, a child logger with its own level, and texts logged once, throttled or not at first."""

from __future__ import annotations

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.logging import LoggingSeverity
from rclpy.node import Node


class Chatterbox(Node):
    """Logs ten times a second."""

    def __init__(self) -> None:
        super().__init__("chatterbox")
        log = self.get_logger()
        log.debug("Not seen: the level is INFO")
        log.info("All is well")
        log.warning("All may not be well")
        log.error("Something is wrong")
        log.fatal("All is lost")
        self.detail = log.get_child("detail")
        self.detail.set_level(LoggingSeverity.DEBUG)
        self.detail.debug("Seen: this logger's level is DEBUG")
        self.timer = self.create_timer(0.1, self.on_timer)
        self.count = 0

    def on_timer(self) -> None:
        self.count += 1
        log = self.get_logger()
        log.info(f"Only the first time: {self.count}", once=True)
        log.info(f"Not the first time: {self.count}", skip_first=True)
        log.info(f"Each second: {self.count}", throttle_duration_sec=1.0)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Chatterbox())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
