"""Test launch descriptions with nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("launch_testing_ros")

__all__ = [
    "DataRepublisher",
    "LaunchTestRunner",
    "MessagePump",
    "WaitForTopics",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing_ros import data_republisher as data_republisher
    from launch_testing_ros import message_pump as message_pump
    from launch_testing_ros import pytest as pytest
    from launch_testing_ros import test_runner as test_runner
    from launch_testing_ros import tools as tools
    from launch_testing_ros import wait_for_topics as wait_for_topics
    from tfloom.launch.testing.ros.data_republisher import DataRepublisher as DataRepublisher
    from tfloom.launch.testing.ros.message_pump import MessagePump as MessagePump
    from tfloom.launch.testing.ros.test_runner import LaunchTestRunner as LaunchTestRunner
    from tfloom.launch.testing.ros.wait_for_topics import WaitForTopics as WaitForTopics
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DataRepublisher="tfloom.launch.testing.ros.data_republisher",
        LaunchTestRunner="tfloom.launch.testing.ros.test_runner",
        MessagePump="tfloom.launch.testing.ros.message_pump",
        WaitForTopics="tfloom.launch.testing.ros.wait_for_topics",
        data_republisher="launch_testing_ros",
        message_pump="launch_testing_ros",
        pytest="launch_testing_ros",
        test_runner="launch_testing_ros",
        tools="launch_testing_ros",
        wait_for_topics="launch_testing_ros",
    )
