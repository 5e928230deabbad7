"""A verb and a command that extend ROS's command, with the functions that they ask the graph by."""

from __future__ import annotations

import argparse

from angles import shortest_angular_distance
from rcl_interfaces.msg import ParameterValue
from rclpy.node import Node
from rclpy.qos import QoSProfile
from resource_retriever import get_filename
from ros2action.api import get_action_clients_and_servers
from ros2bag.api import convert_yaml_to_qos_profile
from ros2cli.command import CommandExtension, add_subparsers_on_demand
from ros2cli.node.direct import DirectNode
from ros2cli.node.strategy import NodeStrategy, add_arguments
from ros2component.api import ComponentInfo, get_components_in_container
from ros2interface.api import type_completer
from ros2lifecycle.api import call_get_states
from ros2node.api import NodeName, get_node_names, get_publisher_info
from ros2param.api import call_get_parameters, call_list_parameters, get_value
from ros2pkg.api import get_package_names
from ros2run.api import get_executable_path
from ros2service.api import get_service_names_and_types
from ros2topic.api import get_msg_class, get_topic_names_and_types, qos_profile_from_short_keys
from ros2topic.verb import VerbExtension
from ros2topic.verb.echo import EchoVerb
from ros2topic.verb.hz import ROSTopicHz
from rosidl_adapter.parser import MessageSpecification, parse_message_string


class CountVerb(VerbExtension):
    """Print the number of topics."""

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        add_arguments(parser)

    def main(self, *, args: argparse.Namespace) -> int:
        with NodeStrategy(args) as node:
            names: list[NodeName] = get_node_names(node=node, include_hidden_nodes=True)
            topics: list[str] = [name for name, _ in get_topic_names_and_types(node=node)]
            services = dict(get_service_names_and_types(node=node))
            clients, servers = get_action_clients_and_servers(node=node, action_name="/count")
            for info in get_publisher_info(node=node, remote_node_name=names[0].full_name):
                print(info.name, info.types)
        print(len(topics), len(services), len(clients), len(servers))
        return 0


class BridgedEchoVerb(EchoVerb):
    """Print the messages of a bridged topic."""

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        super().add_arguments(parser, cli_name)
        parser.add_argument("--bridge")

    def main(self, *, args: argparse.Namespace) -> int | str | None:
        return super().main(args=args)


def measure(node: Node) -> float:
    measured = ROSTopicHz(node, 100).get_hz("/a")
    is_there, components = get_components_in_container(node=node, remote_container_node_name="/a")
    print(is_there, [part.uid for part in components if isinstance(part, ComponentInfo)])
    print(call_get_states(node=node, node_names=["/b"])["/b"])
    return 0.0 if measured is None else measured[0] * 1e9


class TreeCommand(CommandExtension):
    """Show trees."""

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> int:
        parser.print_help()
        return 0


def parameters_of(node_name: str) -> dict[str, object]:
    with DirectNode(argparse.Namespace()) as node:
        future = call_list_parameters(node=node, node_name=node_name)
        if future is None:
            return {}
        names: list[str] = list(future.result().result.names)
        values = call_get_parameters(node=node, node_name=node_name, parameter_names=names).values
        return dict(zip(names, (get_value(parameter_value=value) for value in values), strict=False))


def use(node: Node, value: ParameterValue) -> None:
    profile: QoSProfile = qos_profile_from_short_keys("sensor_data", depth=3)
    profiles: dict[str, QoSProfile] = convert_yaml_to_qos_profile({"/a": {"depth": 1}})
    message: MessageSpecification = parse_message_string("pkg", "Foo", "int8 a")
    path: str | None = get_executable_path(package_name="turtlesim", executable_name="turtlesim_node")
    print(profile, profiles, [field.name for field in message.fields], path, get_msg_class(node, "/a"), value)
    print(len(get_package_names()), type_completer(), get_filename("package://turtlesim/msg"))
    print(shortest_angular_distance(0.0, 1.0), add_subparsers_on_demand)
