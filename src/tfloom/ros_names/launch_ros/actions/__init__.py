"""Actions that start nodes, or that change how later ones are started."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ComposableNodeContainer",
    "LifecycleNode",
    "LifecycleTransition",
    "LoadComposableNodes",
    "Node",
    "PushROSNamespace",
    "PushRosNamespace",
    "ROSTimer",
    "RosTimer",
    "SetParameter",
    "SetParametersFromFile",
    "SetROSLogDir",
    "SetRemap",
    "SetUseSimTime",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.actions import composable_node_container as composable_node_container
    from launch_ros.actions import lifecycle_node as lifecycle_node
    from launch_ros.actions import lifecycle_transition as lifecycle_transition
    from launch_ros.actions import load_composable_nodes as load_composable_nodes
    from launch_ros.actions import node as node
    from launch_ros.actions import push_ros_namespace as push_ros_namespace
    from launch_ros.actions import ros_timer as ros_timer
    from launch_ros.actions import set_parameter as set_parameter
    from launch_ros.actions import set_parameters_from_file as set_parameters_from_file
    from launch_ros.actions import set_remap as set_remap
    from launch_ros.actions import set_ros_log_dir as set_ros_log_dir
    from launch_ros.actions import set_use_sim_time as set_use_sim_time
    from tfloom.launch.ros.actions.composable_node_container import ComposableNodeContainer as ComposableNodeContainer
    from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode as LifecycleNode
    from tfloom.launch.ros.actions.lifecycle_transition import LifecycleTransition as LifecycleTransition
    from tfloom.launch.ros.actions.load_composable_nodes import LoadComposableNodes as LoadComposableNodes
    from tfloom.launch.ros.actions.node import Node as Node
    from tfloom.launch.ros.actions.push_ros_namespace import PushROSNamespace as PushROSNamespace
    from tfloom.launch.ros.actions.push_ros_namespace import PushRosNamespace as PushRosNamespace
    from tfloom.launch.ros.actions.ros_timer import ROSTimer as ROSTimer
    from tfloom.launch.ros.actions.ros_timer import RosTimer as RosTimer
    from tfloom.launch.ros.actions.set_parameter import SetParameter as SetParameter
    from tfloom.launch.ros.actions.set_parameters_from_file import SetParametersFromFile as SetParametersFromFile
    from tfloom.launch.ros.actions.set_remap import SetRemap as SetRemap
    from tfloom.launch.ros.actions.set_ros_log_dir import SetROSLogDir as SetROSLogDir
    from tfloom.launch.ros.actions.set_use_sim_time import SetUseSimTime as SetUseSimTime
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ComposableNodeContainer="tfloom.launch.ros.actions.composable_node_container",
        LifecycleNode="tfloom.launch.ros.actions.lifecycle_node",
        LifecycleTransition="tfloom.launch.ros.actions.lifecycle_transition",
        LoadComposableNodes="tfloom.launch.ros.actions.load_composable_nodes",
        Node="tfloom.launch.ros.actions.node",
        PushROSNamespace="tfloom.launch.ros.actions.push_ros_namespace",
        PushRosNamespace="tfloom.launch.ros.actions.push_ros_namespace",
        ROSTimer="tfloom.launch.ros.actions.ros_timer",
        RosTimer="tfloom.launch.ros.actions.ros_timer",
        SetParameter="tfloom.launch.ros.actions.set_parameter",
        SetParametersFromFile="tfloom.launch.ros.actions.set_parameters_from_file",
        SetROSLogDir="tfloom.launch.ros.actions.set_ros_log_dir",
        SetRemap="tfloom.launch.ros.actions.set_remap",
        SetUseSimTime="tfloom.launch.ros.actions.set_use_sim_time",
        composable_node_container="launch_ros.actions",
        lifecycle_node="launch_ros.actions",
        lifecycle_transition="launch_ros.actions",
        load_composable_nodes="launch_ros.actions",
        node="launch_ros.actions",
        push_ros_namespace="launch_ros.actions",
        ros_timer="launch_ros.actions",
        set_parameter="launch_ros.actions",
        set_parameters_from_file="launch_ros.actions",
        set_remap="launch_ros.actions",
        set_ros_log_dir="launch_ros.actions",
        set_use_sim_time="launch_ros.actions",
    )
