"""Compare what tfloom sends on Zenoh with what a stock rmw_zenoh sends: `same`, or the first difference.

    python -m tests.oracles.compare_rmw_zenoh /usr/bin/python3

The argument is the Python of a ROS 2 with rmw_zenoh_cpp and example_interfaces. Run it in the environment of tfloom, in
a shell where ROS 2 is not sourced; `--setup /opt/ros/jazzy/setup.bash` sources it for the stock program alone.
A router of tfloom's on loopback links both; each runs `tests/rmw/programs/zenoh_compared.py`, one after the other.
"""

from __future__ import annotations

import argparse
import os
import shlex
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zenoh

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import QoS
from tfloom.rmw.zenoh.tokens import (
    End,
    Kind,
    Token,
    data_key,
    gid_of,
    pack_attachment,
    parse_token,
    token_key,
    token_pattern,
    unpack_attachment,
)
from tfloom.rosidl.cdr import encode

if TYPE_CHECKING:
    from typing_extensions import Self

PROGRAM = Path(__file__).parents[1] / "rmw" / "programs" / "zenoh_compared.py"
TIMEOUT_S = 60.0
TOPICS = ("back", "be", "ka", "latched_real")
GID = bytes(range(16))


def main(arguments: list[str] | None = None) -> int:
    """Print `same`, or the first difference."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("python", help="Python of the stock ROS 2")
    parser.add_argument("--setup", default="", help="shell file that is sourced for it")
    parser.add_argument("--port", type=int, default=7447, help="port of the router on loopback")
    parser.add_argument("--domain", type=int, default=99, help="a domain that nobody else uses")
    args = parser.parse_args(arguments)
    command = [args.python, str(PROGRAM)]
    if args.setup:
        command = ["bash", "-c", f"source {shlex.quote(args.setup)} && exec {shlex.join(command)}"]
    with running_router(args.port):
        ours = recorded([sys.executable, str(PROGRAM)], args.domain, args.port)
        theirs = recorded(command, args.domain, args.port)
    difference = first_difference(ours, theirs)
    print(difference or "same")
    return 1 if difference else 0


def first_difference(ours: list[str], theirs: list[str]) -> str:
    """Return the first line that one record has and the other one hasn't; empty if there is none."""
    for line in sorted({*ours, *theirs}):
        if ours.count(line) != theirs.count(line):
            return f"tfloom {ours.count(line)} times, rmw_zenoh {theirs.count(line)} times: {line}"
    return ""


def recorded(command: list[str], domain_id: int, port: int) -> list[str]:
    """Run a program, and return its tokens, samples, request and response, without ids and times."""
    variables = {
        "RMW_IMPLEMENTATION": "rmw_zenoh_cpp",
        "ROS_DOMAIN_ID": str(domain_id),
        "TFLOOM_ZENOH_PORT": str(port),
        "ZENOH_CONFIG_OVERRIDE": f'connect/endpoints=["tcp/127.0.0.1:{port}"]',
    }
    with client_session(port) as session, _Recorder(session, domain_id) as recorder:
        program = subprocess.Popen(
            command,
            env={**os.environ, **variables},
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            text=True,
        )
        try:
            recorder.wait(lambda: program.poll() is not None)
        finally:
            program.stdin.close()  # type: ignore[union-attr]
            try:
                program.wait(TIMEOUT_S)
            except subprocess.TimeoutExpired:
                program.kill()
                program.wait()
        return recorder.lines()


@contextmanager
def running_router(port: int) -> Iterator[None]:
    command = [sys.executable, "-m", "tfloom", "zenoh", "router", "-l", f"tcp/127.0.0.1:{port}"]
    router = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        said = ""
        while "listening on" not in said:
            line = router.stdout.readline()  # type: ignore[union-attr]
            if not line:
                raise SystemExit(f"no router could be started at port {port}: {said}")
            said += line
        yield
    finally:
        router.terminate()
        router.communicate()


@contextmanager
def client_session(port: int) -> Iterator[Any]:
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", f'["tcp/127.0.0.1:{port}"]')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("timestamping/enabled", "true")
    with zenoh.open(config) as session:
        yield session


class _Recorder:
    """Stands beside a program: hears its tokens and samples, is its server, and is its client."""

    def __init__(self, session: Any, domain_id: int) -> None:
        self._session = session
        self._domain_id = domain_id
        self._lock = threading.Lock()
        self._tokens: dict[str, Token] = {}
        self._samples: dict[str, Any] = {}
        self._request: Any = None
        self._reply: Any = None
        self._own = str(session.zid())
        self._service = self._key("/our_add")
        self._ends: list[Any] = []

    def _key(self, name: str) -> str:
        return data_key(self._domain_id, name, AddTwoInts._TYPE_NAME, AddTwoInts._TYPE_HASH)

    def __enter__(self) -> Self:
        callback = zenoh.handlers.Callback
        session, domain = self._session, self._domain_id
        end = End("/our_add", AddTwoInts._TYPE_NAME, AddTwoInts._TYPE_HASH, QoS())
        token = Token(domain, self._own, 0, 1, Kind.SERVER, "/", NodeName("/", "recorder"), end)
        self._ends = [
            session.declare_queryable(self._service, callback(self._on_query, indirect=False), complete=True),
            session.liveliness().declare_token(token_key(token)),
            session.liveliness().declare_subscriber(
                token_pattern(domain), callback(self._on_token, indirect=False), history=True
            ),
            *(
                session.declare_subscriber(f"{domain}/{topic}/**", callback(self._on_sample, indirect=False))
                for topic in TOPICS
            ),
        ]
        return self

    def __exit__(self, *_: object) -> None:
        for end in self._ends:
            end.undeclare()

    def _on_token(self, sample: Any) -> None:
        token = parse_token(str(sample.key_expr))
        if token.zid != self._own and sample.kind == zenoh.SampleKind.PUT:
            with self._lock:
                self._tokens[str(sample.key_expr)] = token

    def _on_sample(self, sample: Any) -> None:
        with self._lock:
            self._samples.setdefault(str(sample.key_expr), sample)

    def _on_query(self, query: Any) -> None:
        with self._lock:
            self._request = (query.payload.to_bytes(), query.attachment)
        query.drop()

    def _on_reply(self, reply: Any) -> None:
        with self._lock:
            self._reply = reply.ok

    def wait(self, has_ended: Callable[[], bool]) -> None:
        """Wait until all has been heard once."""
        end = time.monotonic() + TIMEOUT_S
        while len(self._samples) < len(TOPICS) or self._request is None or self._reply is None:
            if has_ended() or time.monotonic() > end:
                raise SystemExit(
                    f"the program {'ended' if has_ended() else 'was not heard in time'}: "
                    f"{len(self._tokens)} tokens, {len(self._samples)} of {len(TOPICS)} samples, "
                    f"{'no' if self._request is None else 'a'} request, {'no' if self._reply is None else 'a'} response"
                )
            if self._reply is None:
                self._session.get(
                    self._key("/real_add"),
                    zenoh.handlers.Callback(self._on_reply, indirect=False),
                    payload=encode(AddTwoInts.Request(a=1, b=2)),
                    attachment=pack_attachment(7, GID),
                    target=zenoh.QueryTarget.ALL_COMPLETE,
                    consolidation=zenoh.ConsolidationMode.NONE,
                )
            time.sleep(0.1)

    def lines(self) -> list[str]:
        """Return all that was heard, without ids and times."""
        gids = {
            kind: {gid_of(key) for key, token in self._tokens.items() if token.kind is kind} for kind in Kind
        }
        lines = [
            "token " + token_key(token._replace(zid="ZID", node_number=0, entity_number=0))
            for token in self._tokens.values()
        ]
        for key, sample in self._samples.items():
            lines.append(
                f"sample {key}: {sample.payload.to_bytes().hex()}, {_form(sample.attachment, gids[Kind.PUBLISHER])}"
            )
        payload, attachment = self._request
        lines.append(f"request: {payload.hex()}, {_form(attachment, gids[Kind.CLIENT])}")
        reply = self._reply
        header = unpack_attachment(reply.attachment)
        lines.append(
            f"response {reply.key_expr}: {reply.payload.to_bytes().hex()}, number {header and header.sequence_number}, "
            f"{'the' if header and header.gid == GID else 'another'} client's gid"
        )
        return lines


def _form(attachment: Any, gids: set[bytes]) -> str:
    """Return what an attachment is like."""
    header = unpack_attachment(attachment)
    if header is None:
        return "no attachment"
    is_now = abs(header.source_stamp_ns - time.time_ns()) < TIMEOUT_S * 1e9
    return (
        f"attachment of {len(attachment.to_bytes())} bytes, "
        f"number {'from 1' if header.sequence_number >= 1 else 'below 1'}, "
        f"{'the present time' if is_now else 'another time'}, "
        f"{'the gid of its token' if header.gid in gids else 'a gid of no token'}"
    )


if __name__ == "__main__":
    sys.exit(main())
