"""The programs rqt_graph, rqt_plot and rqt_console of their packages: the page of `tfloom view`, open at a panel."""

from __future__ import annotations

import argparse
import sys

from tfloom.cli import view
from tfloom.common.terminal import report
from tfloom.node.context.arguments import parse_arguments
from tfloom.viewer.extra import MISSING, is_installed

__all__ = ["run_console", "run_graph", "run_plot"]

WITHOUT_EFFECT = (
    (("-t", "--freeze-layout"), None),
    (("-l", "--lock-perspective"), None),
    (("-f", "--force-discover"), None),
    (("--clear-config",), None),
    (("-p", "--perspective"), "NAME"),
    (("--perspective-file",), "FILE"),
    (("-b", "--qt-binding"), "NAME"),
)
"""Options of windows, which launch files give, with the name of the value that each takes."""


def run_graph(args: list[str] | None = None) -> int:
    """Run `ros2 run rqt_graph rqt_graph`: serve the page, with the graph, until Ctrl-C; return the exit code."""
    return _run("rqt_graph", "graph", args)


def run_console(args: list[str] | None = None) -> int:
    """Run `ros2 run rqt_console rqt_console`: serve the page, with the log, until Ctrl-C; return the exit code."""
    return _run("rqt_console", "log", args)


def run_plot(args: list[str] | None = None) -> int:
    """Run `ros2 run rqt_plot rqt_plot`: serve the page, with the plots, until Ctrl-C; return the exit code."""
    return _run("rqt_plot", "plots", args)


def _run(name: str, panel: str, args: list[str] | None) -> int:
    parsed = parse_arguments(sys.argv[1:] if args is None else args)
    words = _parser(name, panel).parse_args(parsed.rest)
    if not is_installed():
        report(f"{name}: {MISSING.format(name=f'the page that stands in for {name}')}")
        return 1
    asked = ["--panel", panel]
    for path in getattr(words, "topics", ()):
        asked += ["--plot", path]
    full = f"{parsed.namespace(name, '/').rstrip('/')}/{parsed.node_name(name)}"
    if parsed.parameter_overrides(full).get("use_sim_time") is True:
        asked.append("--use-sim-time")
    print(f"{name}: the panel {panel.capitalize()} of `tfloom view` stands in for {name}", flush=True)
    return view.serve_as(name, asked)


def _parser(name: str, panel: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog=name, description=f"Show the panel {panel.capitalize()} of the page of `tfloom view`."
    )
    if panel == "plots":
        parser.add_argument(
            "topics",
            metavar="TOPIC/FIELD",
            nargs="*",
            help="a numeric field, as /turtle1/pose/x; several, as /turtle1/pose/x:y; or a topic, for all",
        )
        parser.add_argument("-P", "--pause", action="store_true", help="it has no effect")
        parser.add_argument("-e", "--empty", action="store_true", help="the page begins without plots anyway")
    for flags, value in WITHOUT_EFFECT:
        kind = {"action": "store_true"} if value is None else {"metavar": value}
        parser.add_argument(*flags, help="it is of a window, and has no effect", **kind)  # type: ignore[arg-type]
    return parser
