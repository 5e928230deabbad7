"""Publish the static transforms of a file until Ctrl-C."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError, wait_for_ctrl_c
from tfloom.cli.shared.listen import shown_node
from tfloom.cli.shared.names import full_topic_name, named_node
from tfloom.tf2_tools.text import counted
from tfloom.tf2_tools.watch.model import STATIC_TOPIC


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf publish`."""
    parser.add_argument("file", help="a file of static transforms, as `tf save` writes it")
    parser.add_argument(
        "-n", "--node-name", help="name of the node that publishes (default: from the file's name)"
    )
    parser.add_argument(
        "--tf-static-topic",
        default=STATIC_TOPIC,
        help=f"topic of static transforms (default: {STATIC_TOPIC})",
    )
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="stamp with the time on /clock")


def main(args: argparse.Namespace) -> int:
    """Publish all in one message, which late subscribers receive, too, until Ctrl-C."""
    from tfloom.cli.shared.sim_time import clock, wait_until_known
    from tfloom.interfaces.tf2_msgs.msg import TFMessage
    from tfloom.rmw.qos import DurabilityPolicy, QoS
    from tfloom.rmw.typed_names import topic_of
    from tfloom.tf2_tools.static_file import StaticFileError, encoded, read_statics

    try:
        transforms = read_statics(Path(args.file))
    except StaticFileError as error:
        raise CommandError(str(error)) from None
    if not transforms:
        raise CommandError(f"{args.file}: there is no static transform in it")
    name = full_topic_name(args.tf_static_topic)
    node = named_node(args.node_name or _node_name(args.file))
    latched = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)
    with graph.joined_participant() as participant, shown_node(participant, node):
        writer = participant.create_writer(node, topic_of(TFMessage, name), latched)
        try:
            with clock(participant, node, simulated=args.use_sim_time) as now_ns:
                if args.use_sim_time:
                    wait_until_known(now_ns)
                writer.write(encoded(transforms, now_ns()))
            print(f"{node.full}: {counted(len(transforms), 'static transform')} on {name}, until Ctrl-C")
            wait_for_ctrl_c()
        except KeyboardInterrupt:
            return 0
        finally:
            writer.close()


def _node_name(path: str) -> str:
    """Return a name of a node that says which file it publishes: `robot-1.yaml` is `static_transforms_robot_1`."""
    return "static_transforms_" + re.sub(r"[^A-Za-z0-9]+", "_", Path(path).stem).strip("_")
