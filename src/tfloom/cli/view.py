"""Show frames, robots and sensors in a browser, of a live graph or of a recording."""

from __future__ import annotations

import argparse
import re
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import full_name, full_topic_name
from tfloom.cli.shared.numbers import seconds
from tfloom.common.terminal import has_browser, report, shown_part
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, TF_TOPIC
from tfloom.viewer.extra import MISSING, is_description, is_installed

if TYPE_CHECKING:
    from tfloom.viewer.described import RobotFile
    from tfloom.viewer.joints import Joints
    from tfloom.viewer.layout.layout import Layout
    from tfloom.viewer.program import Viewer

__all__ = ["Publishing", "add_arguments", "main", "read_config", "serve", "serve_as", "start_pages"]

PORT = 8765
PANELS = ("displays", "doctor", "frames", "graph", "joints", "log", "parameters", "plots", "send")
"""The panels of a page, as `?panel=` of its address names them."""
HISTORY_S = 60.0
MAX_END_S = 0.5
"""How long a picture may take after Ctrl-C until it is given up [s]: one of many thousand frames takes seconds."""
MAX_UNKNOWN = 20
"""Number of things that are named of those that a layout has and that are not known here."""
OPEN_TO_ALL = """\
Anyone with this address can see what is published here, publish, call services, and drive robots: it has a token, and \
is not encrypted."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `view`."""
    parser.add_argument(
        "-b", "--bag", metavar="PATH", type=Path, help="a recording, in place of the live graph"
    )
    parser.add_argument(
        "path",
        metavar="PATH",
        nargs="?",
        help="a recording, as --bag PATH; or a robot's description: a file that ends in .urdf or .xacro, also as "
        "package://PACKAGE/PATH",
    )
    parser.add_argument(
        "arguments",
        metavar="NAME:=VALUE",
        nargs="*",
        help="arguments of xacro, of a robot's description",
    )
    parser.add_argument(
        "--publish",
        action="store_true",
        help="publish the robot's frames, its description and the positions of its joints, for other nodes",
    )
    parser.add_argument(
        "-c",
        "--config",
        metavar="FILE",
        type=Path,
        help="a saved layout, or a file of RViz that ends in .rviz",
    )
    parser.add_argument(
        "--save-config", metavar="FILE", type=Path, help="where `Save layout` on the page writes it"
    )
    parser.add_argument("--fixed-frame", metavar="FRAME", default="", help="the frame that stands still")
    parser.add_argument(
        "-d", "--display", metavar="TOPIC", action="append", default=[], help="show a topic from the start"
    )
    parser.add_argument(
        "--plot",
        metavar="TOPIC/FIELD",
        action="append",
        default=[],
        help="plot a numeric field from the start, as /turtle1/pose/x, or all those of a topic",
    )
    parser.add_argument(
        "--panel", choices=PANELS, default="", help="the panel that the page opens with (default: Frames)"
    )
    parser.add_argument(
        "--history",
        metavar="S",
        type=seconds,
        default=HISTORY_S,
        help=f"how far the time can be turned back in seconds (default: {HISTORY_S:g})",
    )
    parser.add_argument(
        "--host",
        default="127.0.0.1",
        help="the address at which to listen (default: 127.0.0.1); at another one, pages need a token",
    )
    parser.add_argument(
        "--port", type=_port, default=None, help=f"the port (default: {PORT}, or a free one if it is used)"
    )
    parser.add_argument(
        "--start-offset",
        metavar="S",
        type=seconds,
        default=None,
        help="begin a recording so many seconds after its first transform (default: where its frames connect)",
    )
    parser.add_argument("--no-open", action="store_true", help="don't open a browser, only print the address")
    parser.add_argument("--tf-topic", default=TF_TOPIC, help=f"topic of transforms (default: {TF_TOPIC})")
    parser.add_argument(
        "--tf-static-topic",
        default=STATIC_TOPIC,
        help=f"topic of static transforms (default: {STATIC_TOPIC})",
    )
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="take the time from /clock")


class Publishing(NamedTuple):
    """What publishes the positions of joints that pages move."""

    urdf_file: str | None
    """Path of the description; None: joint_state_publisher finds it."""
    ros_arguments: list[str]
    """A command line, of which the ROS arguments count."""


def _port(text: str) -> int:
    port = int(text) if text.isascii() and text.isdigit() else -1
    if not 0 <= port <= 65535:
        raise argparse.ArgumentTypeError(f"{text!r} is not a port: it has to be from 0 to 65535")
    return port


def main(args: argparse.Namespace) -> int:
    """Serve pages until Ctrl-C."""
    return serve(args, needs_terminal=True)


def _recording(args: argparse.Namespace) -> Path | None:
    """Return the recording that is named with or without `--bag`; None for the live graph.

    Raises:
        CommandError: two are named, or a file of RViz.
    """
    if args.path is None:
        return args.bag  # type: ignore[no-any-return]
    path = Path(args.path)
    if args.bag is not None:
        raise CommandError(f"two recordings, {args.bag} and {path}: the page shows one")
    if path.suffix == ".rviz":
        raise CommandError(f"{path} is not a recording; to show a layout: --config {path}")
    return path


def _robot_name(args: argparse.Namespace) -> str | None:
    """Return the name of the robot's description that is to be shown; None without one.

    Raises:
        CommandError: there is also a recording, or an option that a description has no use for.
    """
    for word in args.arguments:
        if not re.match(r"\w+:=", word) or not is_description(args.path):
            raise CommandError(
                f"{word} is too much: only a robot's description has arguments, each NAME:=VALUE"
            )
    if args.path is None or not is_description(args.path):
        if args.publish:
            raise CommandError(
                "--publish is for a robot's description: name a file that ends in .urdf or .xacro"
            )
        return None
    if args.bag is not None:
        raise CommandError(f"a recording, {args.bag}, and a robot, {args.path}: the page shows one")
    if args.use_sim_time:
        raise CommandError("a description has no time: leave out --use-sim-time")
    return str(args.path)


def serve(args: argparse.Namespace, *, needs_terminal: bool, publishing: Publishing | None = None) -> int:
    """Serve pages until Ctrl-C.

    Args:
        args: The arguments of `view`.
        needs_terminal: Whether the page is opened in a browser only from a terminal.
        publishing: What publishes joints that pages move, of the graph's robot; None: nothing.

    Raises:
        CommandError: it can't be served.
    """
    robot = _robot_name(args)
    args.bag = _recording(args) if robot is None else None
    if args.start_offset is not None and args.bag is None:
        raise CommandError("argument --start-offset: only a recording has a start")
    if not args.history > 0.0:
        raise CommandError(f"argument --history: must be above 0, not {args.history:g}")
    if not is_installed():
        raise CommandError(MISSING.format(name="`tfloom view`"))
    layout = None if args.config is None else read_config(args.config)
    with _set_by_signals() as over, _opened(args, robot, publishing, over) as viewer:
        _interrupt_by_alarm(viewer)
        viewer.layout_path = args.save_config
        if layout is not None:
            # What the command line says counts before the file.
            start_offset_s = layout.start_offset_s if args.start_offset is None else args.start_offset
            fixed_frame = args.fixed_frame or layout.fixed_frame
            viewer.apply(layout._replace(fixed_frame=fixed_frame, start_offset_s=start_offset_s))
        start_pages(viewer, args.host, args.port)
        for topic in args.display:
            viewer.view.want(full_topic_name(topic))
        _seek_plots(viewer, args.plot)
        has_token = "?token=" in viewer.pages.address
        address = viewer.pages.address
        if args.panel:
            address += f"{'&' if has_token else '?'}panel={args.panel}"
        if has_token:
            print(OPEN_TO_ALL, flush=True)
        print(f"Open {address}", flush=True)
        if not args.no_open and _has_browser(needs_terminal=needs_terminal):
            import webbrowser

            webbrowser.open(address)
        viewer.run(over.is_set)
    return 0


def _seek_plots(viewer: Viewer, paths: list[str]) -> None:
    """Plot what the command line names.

    Raises:
        CommandError: one can't be the name of a field, or there are too many.
    """
    from tfloom.viewer.page_command import PageError

    for path in map(full_name, paths):
        if not re.fullmatch(r"(/[A-Za-z_][\w\[\]:]*)+", path, re.ASCII):
            raise CommandError(f"argument --plot: {path} is not a topic with a field, as /turtle1/pose/x")
        try:
            viewer.view.plots.seek(path)
        except PageError as error:
            raise CommandError(f"argument --plot: {error}") from None


def serve_as(name: str, words: list[str], publishing: Publishing | None = None) -> int:
    """Serve pages in place of a program of another name; return the exit code.

    A user who starts it by a launch file wants to see it, so the page is opened without a terminal, too.

    Args:
        name: The program.
        words: The command line of `view`.
        publishing: As in `serve`.
    """
    parser = argparse.ArgumentParser(prog=name)
    add_arguments(parser)
    try:
        return serve(parser.parse_args(words), needs_terminal=False, publishing=publishing)
    except CommandError as error:
        report(f"{name}: {error}")
        return 1


@contextmanager
def _set_by_signals() -> Iterator[threading.Event]:
    """Give an event that Ctrl-C, SIGTERM and a terminal that is closed set; alarms follow until the block ends."""
    over = threading.Event()

    def end(*_: object) -> None:
        if sys.platform != "win32" and not over.is_set():
            signal.setitimer(signal.ITIMER_REAL, MAX_END_S, MAX_END_S)
        over.set()

    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:  # as by nohup
            signal.signal(number, end)
    if sys.platform != "win32":
        signal.signal(signal.SIGALRM, lambda *_: None)
    try:
        yield over
    finally:
        over.set()
        if sys.platform != "win32":
            # The interpreter's exit restores the default action of an alarm, which kills the process.
            signal.setitimer(signal.ITIMER_REAL, 0)


def _interrupt_by_alarm(viewer: Viewer) -> None:
    """Let the alarm end what is drawn."""
    if sys.platform != "win32":
        signal.signal(signal.SIGALRM, lambda *_: viewer.interrupt())


def read_config(path: Path) -> Layout:
    """Return the layout of a file; a sentence on stderr names what of it is not known here.

    Raises:
        CommandError: it is none.
    """
    from tfloom.viewer.layout.layout import LayoutError
    from tfloom.viewer.layout.layout_file import read_layout

    try:
        layout, unknown = read_layout(path)
    except LayoutError as error:
        raise CommandError(str(error)) from None
    if unknown:
        more = [f"and {len(unknown) - MAX_UNKNOWN} more"] if len(unknown) > MAX_UNKNOWN else []
        named = "; ".join([*map(shown_part, unknown[:MAX_UNKNOWN]), *more])
        report(f"{path}: shown without what is not known here: {named}")
    return layout


def _opened(
    args: argparse.Namespace, robot: str | None, publishing: Publishing | None, over: threading.Event
) -> AbstractContextManager[Viewer]:
    if publishing is not None:
        return _open_published(args, publishing, None, over)
    if robot is not None:
        return _open_robot(robot, args, over)
    return _open_live(args) if args.bag is None else _open_recording(args)


def _topics(args: argparse.Namespace) -> tuple[str, str]:
    return full_topic_name(args.tf_topic), full_topic_name(args.tf_static_topic)


@contextmanager
def _open_live(
    args: argparse.Namespace, joints: Joints | None = None, robot: RobotFile | None = None
) -> Iterator[Viewer]:
    from tfloom.cli.shared.graph import joined_participant, wait_until_quiet
    from tfloom.viewer.live import live_viewer

    fixed_frame = args.fixed_frame or ("" if robot is None else robot.model.description.root)
    with (
        joined_participant() as participant,
        live_viewer(
            participant,
            topics=_topics(args),
            history_s=args.history,
            fixed_frame=fixed_frame,
            simulated=args.use_sim_time,
            joints=joints,
        ) as viewer,
    ):
        wait_until_quiet(participant.graph, 1.0, goes_on=True)
        yield viewer


@contextmanager
def _open_recording(args: argparse.Namespace) -> Iterator[Viewer]:
    from tfloom.bag.errors import BagError
    from tfloom.viewer.recorded import recorded_viewer

    try:
        with recorded_viewer(args.bag, topics=_topics(args), fixed_frame=args.fixed_frame) as viewer:
            if args.start_offset is not None:
                try:
                    viewer.view.start_after(args.start_offset)
                except ValueError as error:
                    raise CommandError(
                        f"argument --start-offset: {args.start_offset:g} s, but {error}"
                    ) from None
            yield viewer
    except BagError as error:
        raise CommandError(str(error)) from None


@contextmanager
def _open_robot(name: str, args: argparse.Namespace, over: threading.Event) -> Iterator[Viewer]:
    from tfloom.viewer.described import (
        DESCRIPTION_TOPIC,
        DescriptionError,
        described_viewer,
        read_robot,
        robot_layout,
    )

    try:
        robot = read_robot(name, args.arguments)
    except DescriptionError as error:
        raise CommandError(str(error)) from None
    if args.publish:
        with _open_published(args, Publishing(None, []), robot, over) as viewer:
            viewer.view.near = robot.folder
            viewer.apply(robot_layout(robot, viewer.view.fixed_frame))
            viewer.view.want(DESCRIPTION_TOPIC)
            yield viewer
        return
    for remark in robot.model.description.remarks[:MAX_UNKNOWN]:
        report(f"{name}, {remark}")
    with described_viewer(robot, fixed_frame=args.fixed_frame) as viewer:
        viewer.view.want(DESCRIPTION_TOPIC)
        yield viewer


@contextmanager
def _open_published(
    args: argparse.Namespace, publishing: Publishing, robot: RobotFile | None, over: threading.Event
) -> Iterator[Viewer]:
    """Open a viewer of the graph, with the joints that this process publishes.

    Raises:
        CommandError: they can't be published.
    """
    from tfloom.robot.robot_state_publisher import StartError
    from tfloom.robot.urdf_faults import UrdfError
    from tfloom.viewer.published_joints import published_joints

    reasons: list[str] = []

    def end(reason: str) -> None:
        reasons.append(reason)
        over.set()

    with ExitStack() as stack:
        try:
            joints = stack.enter_context(
                published_joints(
                    None if robot is None else robot.text,
                    end,
                    args=publishing.ros_arguments,
                    urdf_file=publishing.urdf_file,
                )
            )
        except OSError as error:
            raise CommandError(f"can't read {publishing.urdf_file}: {error.strerror or error}") from None
        except (UrdfError, StartError) as error:
            raise CommandError(f"{publishing.urdf_file or 'robot_description'}: {error}") from None
        except RuntimeError as error:
            raise CommandError(str(error)) from None
        yield stack.enter_context(_open_live(args, joints, robot))
    if reasons:
        raise CommandError(reasons[0])


def start_pages(viewer: Viewer, host: str, port: int | None) -> None:
    """Listen at an address; without a port at the usual one, or at a free one where that is used.

    Raises:
        CommandError: the address can't be used.
    """
    from tfloom.viewer.page_server import ServerError

    try:
        viewer.pages.start(host, PORT if port is None else port)
    except ServerError as error:
        if port is not None:
            raise CommandError(str(error)) from None
        try:
            viewer.pages.start(host, 0)
        except ServerError:
            raise CommandError(str(error)) from None


def _has_browser(*, needs_terminal: bool) -> bool:
    """Return whether a person is there who would see a browser."""
    return has_browser() and (not needs_terminal or (sys.stdout is not None and sys.stdout.isatty()))
