"""Conditions: whether an action is executed."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "IfCondition",
    "InvalidConditionExpressionError",
    "LaunchConfigurationEquals",
    "LaunchConfigurationNotEquals",
    "UnlessCondition",
    "evaluate_condition_expression",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.conditions import evaluate_condition_expression_impl as evaluate_condition_expression_impl
    from launch.conditions import if_condition as if_condition
    from launch.conditions import invalid_condition_expression_error as invalid_condition_expression_error
    from launch.conditions import launch_configuration_equals as launch_configuration_equals
    from launch.conditions import launch_configuration_not_equals as launch_configuration_not_equals
    from launch.conditions import unless_condition as unless_condition
    from tfloom.launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression as evaluate_condition_expression
    from tfloom.launch.conditions.if_condition import IfCondition as IfCondition
    from tfloom.launch.conditions.invalid_condition_expression_error import InvalidConditionExpressionError as InvalidConditionExpressionError
    from tfloom.launch.conditions.launch_configuration_equals import LaunchConfigurationEquals as LaunchConfigurationEquals
    from tfloom.launch.conditions.launch_configuration_not_equals import LaunchConfigurationNotEquals as LaunchConfigurationNotEquals
    from tfloom.launch.conditions.unless_condition import UnlessCondition as UnlessCondition
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IfCondition="tfloom.launch.conditions.if_condition",
        InvalidConditionExpressionError="tfloom.launch.conditions.invalid_condition_expression_error",
        LaunchConfigurationEquals="tfloom.launch.conditions.launch_configuration_equals",
        LaunchConfigurationNotEquals="tfloom.launch.conditions.launch_configuration_not_equals",
        UnlessCondition="tfloom.launch.conditions.unless_condition",
        evaluate_condition_expression="tfloom.launch.conditions.evaluate_condition_expression_impl",
        evaluate_condition_expression_impl="launch.conditions",
        if_condition="launch.conditions",
        invalid_condition_expression_error="launch.conditions",
        launch_configuration_equals="launch.conditions",
        launch_configuration_not_equals="launch.conditions",
        unless_condition="launch.conditions",
    )
