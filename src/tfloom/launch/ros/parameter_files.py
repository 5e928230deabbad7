"""The check that a parameter file is for the node that is given it."""

from __future__ import annotations

from pathlib import Path

from tfloom.launch.logs.logging import get_logger

__all__ = ["warn_of_unmatched"]


def warn_of_unmatched(path: Path, node_name: str) -> None:
    """Warn if a parameter file has values, and none for a node of this full name.

    A file that can't be read is left to the node, which reports it.
    """
    from tfloom.node.parameters.parameter_file import read_parameter_file

    try:
        rules = read_parameter_file(path)
    except (OSError, ValueError):
        return
    if rules and not any(rule.is_for(node_name) for rule in rules):
        nodes = ", ".join(dict.fromkeys(rule.node for rule in rules))
        get_logger("launch_ros.actions.node").warning(
            f"the parameter file {path} has no values for the node {node_name}: it has those of {nodes}"
        )
