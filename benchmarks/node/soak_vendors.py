"""A soak test of mixed vendors: `python -m benchmarks.node.soak_vendors --seconds 600`.

Members on tfloom and on the real rclpy with Fast DDS (`soak_member.py`) exchange numbered messages on a topic, each
with each, and call one another's services. Some stay; every few seconds one of the others is killed by SIGKILL and
replaced, at any moment of its life. Checked are:

- no member receives a message twice, and none on tfloom one after a later one; those that stay receive all of one
  another, and none loses one, but while the sender or the receiver is newer than NEW_S: what is sent before both know
  of the match is lost on DDS;
- each call is answered once, by the right server, or fails by name; it fails only if the called process was killed;
- members that stay list those that are alive, and no others, once the leases of the killed have ended;
- the memory of tfloom's members that stay is constant (`memory.py`), in MIN_STEADY_S or more, because libddsc's grows
  until some hundred processes have left; that of Fast DDS is reported only.

The exit code is 1 if one of these is not so.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import subprocess
import sys
import threading
import time
from collections import Counter, deque
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tools.ros_peer import RosPeer, find

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.memory import Memory
from benchmarks.node.soak_member import LIVES

MEMBER = Path(__file__).with_name("soak_member.py")
OURS, THEIRS = "tfloom", "Fast DDS"
STAYING = (OURS, OURS, THEIRS, THEIRS)
KILLED = (OURS, OURS, THEIRS, THEIRS)
SLOTS = (*STAYING, *KILLED)
"""The vendor of each slot; a process that replaces another one is in the same slot."""
KILL_EVERY_S = (2.0, 5.0)
STATUS_EVERY_S = 1.0
LEASE_S = 20.0
"""The time after which a killed process is removed from the graph: Fast DDS's, the longer one [s]."""
SETTLE_S = 25.0
"""Time without kills at the end: the longest lease, and the discovery of the last process."""
NEW_S = 10.0
"""The age of a process until which others may not have discovered it [s]."""
MIN_STEADY_S = 1800.0
PATIENCE_S = 60.0
MAX_FAULTS = 20
_ENDED = object()
"""Follows the answers of a process that has ended."""


class Member:
    """A process in a slot."""

    def __init__(self, slot: int, life: int, domain_id: int, peer: RosPeer) -> None:
        self.slot, self.life = slot, life
        self.vendor = SLOTS[slot]
        self.name = f"soak_{slot}_{life}"
        self.key = str(slot * LIVES + life)
        self.last: dict[str, Any] = {}
        self.start_s = time.time()
        self._answers: deque[Any] = deque()
        python = sys.executable if self.vendor == OURS else peer.python
        ours = os.environ | {"ROS_DOMAIN_ID": str(domain_id)}
        self.process = subprocess.Popen(
            [python, MEMBER, self.name, str(slot), str(life), str(len(SLOTS))],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=ours if self.vendor == OURS else peer.environment(domain_id),
        )
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            if line.startswith("= "):
                self._answers.append(json.loads(line[2:]))
        self._answers.append(_ENDED)

    def is_ready(self) -> bool:
        """Return whether the node is there, which prints a first answer."""
        return bool(self._answers) or bool(self.last)

    def ask(self, command: str) -> Any:
        """Return the answer to a command.

        Raises:
            RuntimeError: the process does not answer.
        """
        assert self.process.stdin is not None
        if not self.last:
            self._next_answer()
            self.last = {"is_ready": True}
        try:
            self.process.stdin.write(command + "\n")
            self.process.stdin.flush()
        except OSError as error:
            raise RuntimeError(f"{self.name} on {self.vendor} has ended: {error}") from None
        return self._next_answer()

    def _next_answer(self) -> Any:
        end = time.monotonic() + PATIENCE_S
        while not self._answers:
            if time.monotonic() > end:
                raise RuntimeError(f"{self.name} on {self.vendor} does not answer")
            time.sleep(0.002)
        answer = self._answers.popleft()
        if answer is _ENDED:
            raise RuntimeError(f"{self.name} on {self.vendor} ended with {self.process.wait()}")
        return answer

    def kill(self) -> None:
        self.process.kill()
        self.process.communicate()

    def leave(self) -> int:
        """End the input and return the exit code; -9 if the process does not end."""
        try:
            self.process.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.kill()
        return self.process.returncode


class Soak:
    """The members, and what they have reported."""

    def __init__(self, seconds: float, domain_id: int) -> None:
        self._seconds = seconds
        self._domain_id = domain_id
        self._peer = find()
        self._lives = [0] * len(SLOTS)
        self._killed_at: dict[int, list[float]] = {slot: [] for slot in range(len(SLOTS))}
        self._gone: list[Member] = []
        self.members: list[Member] = []
        self.faults: list[str] = []
        self.failures: Counter[str] = Counter()
        self.early_losses: list[float] = []
        """Of each message that a new process has lost: its age [s]."""
        self.memory: dict[str, Memory] = {}

    @property
    def _staying(self) -> list[Member]:
        return self.members[: len(STAYING)]

    def run(self) -> None:
        """Run the members for the time, and check them."""
        with self._all_members():
            self._wait("all members know one another", self._is_complete)
            for member in self.members:
                member.ask("start")
            self.memory = {
                f"{member.name} on {member.vendor}": Memory(member.process.pid, self._seconds)
                for member in self._staying
            }
            self._work()
            self._wait("the listings are right", self._is_complete)
            self._check_command()
            for member in self.members:
                member.ask("stop")
            self._wait(
                "no call is in flight", lambda: not any(member.last["calling"] for member in self.members)
            )
            self._wait("all messages have arrived", self._has_arrived)
            self._check_staying()

    @contextmanager
    def _all_members(self) -> Iterator[None]:
        self.members = [self._start(slot) for slot in range(len(SLOTS))]
        try:
            yield
            for member in self.members:
                if (code := member.leave()) != 0:
                    self.faults.append(f"{member.name} on {member.vendor} ended with {code}")
        except RuntimeError as error:
            self.faults.append(str(error))
        finally:
            for member in self.members:
                if member.process.poll() is None:
                    member.kill()

    def _start(self, slot: int) -> Member:
        self._lives[slot] += 1
        return Member(slot, self._lives[slot], self._domain_id, self._peer)

    def _work(self) -> None:
        begin = time.monotonic()
        end, last_kill = begin + self._seconds, begin + self._seconds - SETTLE_S
        next_kill = begin
        started = {member.key for member in self.members}
        while time.monotonic() < end and len(self.faults) < MAX_FAULTS:
            if next_kill < time.monotonic() < last_kill:
                next_kill = time.monotonic() + random.uniform(*KILL_EVERY_S)
                self._replace(random.randrange(len(STAYING), len(SLOTS)))
            for member in self.members:
                if not member.is_ready():
                    continue
                try:
                    self._note_status(member)
                    if member.key not in started:
                        member.ask("start")
                        started.add(member.key)
                except RuntimeError as error:
                    if member in self._staying:
                        raise
                    self.faults.append(str(error))
                    self._replace(member.slot)
            for memory in self.memory.values():
                memory.note((time.monotonic() - begin) / self._seconds)
            time.sleep(STATUS_EVERY_S)

    def _replace(self, slot: int) -> None:
        member = self.members[slot]
        member.kill()
        self._killed_at[slot].append(time.time())
        self._gone.append(member)
        self.members[slot] = self._start(slot)

    def _note_status(self, member: Member) -> None:
        status = member.ask("status")
        member.last = status
        where = f"{member.name} on {member.vendor}: "
        self.faults += [where + fault for fault in status["faults"]]
        for failure in status["failures"]:
            self._judge_call(member, failure)
        for lost in status["lost"]:
            self._judge_lost(member, lost)
        if member.vendor == OURS and status["late"]:
            self.faults.append(f"{where}{status['late']} messages arrived after later ones")

    def _judge_lost(self, receiver: Member, lost: dict[str, Any]) -> None:
        """Count a lost message; it is a fault if the sender and the receiver were no longer new."""
        sender = next(member for member in (*self.members, *self._gone) if member.key == lost["sender"])
        age_s = min(lost["at_s"] - sender.start_s, lost["at_s"] - receiver.start_s)
        if age_s < NEW_S:
            self.early_losses.append(age_s)
            return
        self.faults.append(
            f"{receiver.name} on {receiver.vendor} lost message {lost['number']} of {sender.name} on {sender.vendor}; "
            f"the newer one was {age_s:.0f} s old"
        )

    def _judge_call(self, member: Member, failure: dict[str, Any]) -> None:
        """Count a failed call; it is a fault if the called process was not killed in the time of a lease before it."""
        slot, how = failure["slot"], failure["how"]
        kills = self._killed_at[slot]
        self.failures[f"{member.vendor}: {how}"] += 1
        if not any(failure["start_s"] - LEASE_S <= killed <= failure["end_s"] for killed in kills):
            self.faults.append(
                f"{member.name} on {member.vendor}: call {failure['number']} of slot {slot}, on {SLOTS[slot]}, whose "
                f"process was not killed: {how}"
            )

    def _wait(self, what: str, is_so: Any) -> None:
        end = time.monotonic() + PATIENCE_S
        while True:
            for member in self.members:
                self._note_status(member)
            if is_so():
                return
            if time.monotonic() > end:
                self.faults.append(f"not within {PATIENCE_S:g} s: {what}; {self._differences()}")
                return
            time.sleep(0.2)

    def _is_complete(self) -> bool:
        return not self._differences()

    def _differences(self) -> list[str]:
        """Return in which members the lists of nodes or the numbers of endpoints aren't those of the living."""
        names = sorted(member.name for member in self.members)
        count = len(names)
        return [
            f"{member.name} on {member.vendor} lists {member.last['nodes']}, {member.last['publishers']} publishers, "
            f"and is matched with {member.last['matched']}"
            for member in self.members
            if (member.last["nodes"], member.last["publishers"], member.last["matched"])
            != (names, count, count)
        ]

    def _check_command(self) -> None:
        """Compare the list of a new process."""
        done = subprocess.run(
            [sys.executable, "-m", "tfloom", "node", "list"],
            env=os.environ | {"ROS_DOMAIN_ID": str(self._domain_id)},
            capture_output=True,
            text=True,
            check=False,
            timeout=PATIENCE_S,
        )
        if done.stdout.split() != sorted(f"/{member.name}" for member in self.members):
            self.faults.append(f"node list printed {done.stdout.split()} {done.stderr.strip()}")

    def _has_arrived(self) -> bool:
        return not any(receiver.last["missing"] for receiver in self.members) and all(
            receiver.last["next"].get(sender.key) == sender.last["sent"]
            for receiver in self.members
            for sender in self.members
        )

    def _check_staying(self) -> None:
        for receiver in self._staying:
            for sender in self._staying:
                if (first := receiver.last["first"].get(sender.key)) != 0:
                    self.faults.append(
                        f"{receiver.name} on {receiver.vendor} received {first} of {sender.name} first"
                    )

    def is_sound(self) -> bool:
        """Return whether nothing was lost or answered wrongly, and no memory of tfloom's members grew."""
        flat = [memory.is_flat() for name, memory in self.memory.items() if name.endswith(OURS)]
        return not self.faults and (all(flat) or self._seconds < MIN_STEADY_S)

    def report(self) -> str:
        """Return what to print at the end."""
        members = [*self._gone, *self.members]
        sums = {
            name: sum(member.last.get(name, 0) for member in members)
            for name in ("sent", "received", "answered", "late")
        }
        killed = Counter(member.vendor for member in self._gone)
        latest_s = max(self.early_losses, default=0.0)
        lines = [
            f"{sums['sent']} messages sent, {sums['received']} received; {sums['answered']} calls answered",
            f"killed: {dict(killed)}; {len(self.faults)} faults",
            f"{self.failures.total()} calls failed by name, as the called process was killed: {dict(self.failures)}",
            f"{len(self.early_losses)} messages lost by new processes, until {latest_s:.1f} s after their start",
            f"{sums['late']} messages arrived after later ones on {THEIRS}",
            *(f"{name}: {memory.report()}" for name, memory in self.memory.items()),
        ]
        return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.soak_vendors", description=__doc__)
    parser.add_argument("--seconds", type=float, default=600.0, help="how long processes are killed")
    parser.add_argument("--domain", type=int, default=DOMAIN_ID, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    soak = Soak(arguments.seconds, arguments.domain)
    soak.run()
    print("\n".join([*soak.faults[:MAX_FAULTS], soak.report()]), flush=True)
    return 0 if soak.is_sound() else 1


if __name__ == "__main__":
    sys.exit(main())
