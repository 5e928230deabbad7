"""`zenoh`: the router, at which the programs of the Zenoh wire meet."""

from __future__ import annotations

import argparse
import sys
import time
from typing import Any, NoReturn

from tfloom.cli.shared.errors import LOOK_S, CommandError, wait_for_ctrl_c
from tfloom.common.terminal import report

NO_LINK_S = 3.0
"""How long a link to another router may be missing before a message says so [s]."""


def add_router_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `zenoh router`."""
    parser.add_argument(
        "-c", "--config", metavar="FILE", help="a JSON5 file, in place of that of ZENOH_ROUTER_CONFIG_URI"
    )
    parser.add_argument(
        "-l",
        "--listen",
        metavar="ENDPOINT",
        action="append",
        help="where to listen, as tcp/0.0.0.0:7447 (default: tcp/127.0.0.1:7447); may be repeated",
    )
    parser.add_argument(
        "-e",
        "--connect",
        metavar="ENDPOINT",
        action="append",
        help="another router to be linked to, as tcp/robot:7447; may be repeated",
    )


def router_main(args: argparse.Namespace) -> int:
    """Route until Ctrl-C; return the exit code."""
    import os

    from tfloom.rmw.zenoh.config import ROUTER_VARIABLE, endpoints_of, mode_of, router_configuration
    from tfloom.rmw.zenoh.meeting_point import open_lone_router

    if args.config:
        os.environ[ROUTER_VARIABLE] = args.config
    asked = {"listen/endpoints": args.listen, "connect/endpoints": args.connect}
    config = router_configuration({key: endpoints for key, endpoints in asked.items() if endpoints})
    if (mode := mode_of(config)) != "router":
        raise CommandError(f'the configuration has the mode "{mode}", a router needs "router"')
    session = open_lone_router(config)
    try:
        listen = ", ".join(endpoints_of(config, "listen/endpoints"))
        connect = ", ".join(endpoints_of(config, "connect/endpoints"))
        linked = f", linked to {connect} as soon as it answers" if connect else ""
        print(f"Started Zenoh router with id {session.zid()}, listening on {listen}{linked}", flush=True)
        if connect:
            _watch_links(session, config)
        wait_for_ctrl_c()
    except KeyboardInterrupt:
        report("Zenoh router ends")
    finally:
        session.close()
    return 0


def _watch_links(session: Any, config: Any) -> NoReturn:
    """Print why there is no link to another router, once until it is made, and when it is made then.

    Zenoh seeks it without end, and tells nobody: a refused certificate would look like a slow start.

    Raises:
        KeyboardInterrupt: Ctrl-C.
    """
    from tfloom.rmw.zenoh.links import unlinked_endpoints, why_no_link

    lacking_since_s: dict[str, float] = {}
    told: set[str] = set()
    while True:
        time.sleep(LOOK_S)
        now_s = time.monotonic()
        unlinked = unlinked_endpoints(session, config)
        for endpoint in [endpoint for endpoint in lacking_since_s if endpoint not in unlinked]:
            del lacking_since_s[endpoint]
            if endpoint in told:
                told.remove(endpoint)
                print(f"linked to {endpoint}", flush=True)
        for endpoint in unlinked:
            if now_s - lacking_since_s.setdefault(endpoint, now_s) > NO_LINK_S and endpoint not in told:
                told.add(endpoint)
                why = why_no_link(endpoint, config)
                report(f"no link to {endpoint} yet, which {why}. It is sought again")


def run_daemon(args: list[str] | None = None) -> int:
    """Run `ros2 run rmw_zenoh_cpp rmw_zenohd`: the router, configured by the environment; return the exit code.

    ROS arguments are accepted and have no effect.
    """
    from tfloom.node.context.utilities import remove_ros_args

    parser = argparse.ArgumentParser(
        prog="rmw_zenohd", description="Route between the programs of the Zenoh wire."
    )
    add_router_arguments(parser)
    return router_main(parser.parse_args(remove_ros_args(sys.argv[1:] if args is None else args)))
