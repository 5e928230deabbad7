"""Test launch descriptions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import launch_testing.parametrize
import launch_testing.ready_to_test_action_timeout
from tfloom.launch.testing.parametrize import parametrize as parametrize
from tfloom.launch.testing.ready_to_test_action_timeout import ready_to_test_action_timeout as ready_to_test_action_timeout

__all__ = [
    "ActiveIoHandler",
    "ActiveProcInfoHandler",
    "IoHandler",
    "ProcInfoHandler",
    "ReadyAggregator",
    "parametrize",
    "post_shutdown_test",
    "ready_to_test_action_timeout",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing import actions as actions
    from launch_testing import asserts as asserts
    from launch_testing import decorator as decorator
    from launch_testing import event_handlers as event_handlers
    from launch_testing import io_handler as io_handler
    from launch_testing import junitxml as junitxml
    from launch_testing import launch_test as launch_test
    from launch_testing import legacy as legacy
    from launch_testing import loader as loader
    from launch_testing import markers as markers
    from launch_testing import parse_arguments as parse_arguments
    from launch_testing import print_arguments as print_arguments
    from launch_testing import proc_info_handler as proc_info_handler
    from launch_testing import pytest as pytest
    from launch_testing import ready_aggregator as ready_aggregator
    from launch_testing import test_result as test_result
    from launch_testing import test_runner as test_runner
    from launch_testing import tools as tools
    from launch_testing import util as util
    from tfloom.launch.testing.decorator import post_shutdown_test as post_shutdown_test
    from tfloom.launch.testing.io_handler import ActiveIoHandler as ActiveIoHandler
    from tfloom.launch.testing.io_handler import IoHandler as IoHandler
    from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler as ActiveProcInfoHandler
    from tfloom.launch.testing.proc_info_handler import ProcInfoHandler as ProcInfoHandler
    from tfloom.launch.testing.ready_aggregator import ReadyAggregator as ReadyAggregator
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ActiveIoHandler="tfloom.launch.testing.io_handler",
        ActiveProcInfoHandler="tfloom.launch.testing.proc_info_handler",
        IoHandler="tfloom.launch.testing.io_handler",
        ProcInfoHandler="tfloom.launch.testing.proc_info_handler",
        ReadyAggregator="tfloom.launch.testing.ready_aggregator",
        actions="launch_testing",
        asserts="launch_testing",
        decorator="launch_testing",
        event_handlers="launch_testing",
        io_handler="launch_testing",
        junitxml="launch_testing",
        launch_test="launch_testing",
        legacy="launch_testing",
        loader="launch_testing",
        markers="launch_testing",
        parse_arguments="launch_testing",
        post_shutdown_test="tfloom.launch.testing.decorator",
        print_arguments="launch_testing",
        proc_info_handler="launch_testing",
        pytest="launch_testing",
        ready_aggregator="launch_testing",
        test_result="launch_testing",
        test_runner="launch_testing",
        tools="launch_testing",
        util="launch_testing",
    )
