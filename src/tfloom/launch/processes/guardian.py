"""A process that ends a launch's processes when the launch itself was killed: `python -S …/guardian.py ID TIME`.

Its stdin is a pipe, whose other end only the launch holds; the kernel closes it with the launch, however that ended.
"""

from __future__ import annotations

import signal
import sys

STEPS = {"SIGINT": 3.0, "SIGTERM": 2.0}
"""Time that the processes have after each signal [s], before SIGKILL."""


def main(arguments: list[str]) -> int:
    """Read lines until the launch has ended, and end and remove what is left of it.

    A line is the id of a process group whose first process has started; `ended`, such an id, and the members that this
    process has left there, each as id and start with a colon between; or `remove` and the path of a folder in
    hexadecimal digits.
    """
    # A user who ends the launch by a signal may send it to all of their processes. The guardian is needed after that.
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    launch_id, since_s = arguments[0], float(arguments[1])
    lines = [line.split() for line in sys.stdin.buffer]  # until the launch has ended: the guardian waits here
    folders = [bytes.fromhex(words[1].decode()) for words in lines if words[0] == b"remove"]
    # Not needed before, as the next: `site` finds the packages.
    import shutil
    import site

    site.main()
    from tfloom.launch.processes import family

    # In the order of the lines: the system may have given the id of a group that has ended to a later process of the
    # launch, and the last line about an id is the one that holds.
    groups: family.Groups = {}
    for words in lines:
        if words[0] == b"ended":
            members = (word.split(b":") for word in words[2:])
            groups[int(words[1])] = {(int(pid), float(start)) for pid, start in members}
        elif words[0].isdigit():
            groups[int(words[0])] = None
    family.end(launch_id, groups, since_s, {signal.Signals[name]: wait_s for name, wait_s in STEPS.items()})
    for folder in folders:
        shutil.rmtree(folder.decode(), ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
