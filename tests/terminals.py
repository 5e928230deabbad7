"""Programs on a terminal of a test."""

from __future__ import annotations

import os
import pty
import subprocess
import sys


def on_a_terminal(program: str, *, typed: str = "", **environment: str) -> str:
    """Run a Python program with a terminal for its output and its errors, and return what reaches the terminal.

    Args:
        program: Its text.
        typed: What is typed at the start, which the terminal shows, too.
        environment: Variables of its environment, beside those of this process.
    """
    ours, theirs = pty.openpty()
    present = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    env = present | {"RMW_IMPLEMENTATION": "tfloom_local", "PYTHONUTF8": "1", "TERM": "xterm"} | environment
    process = subprocess.Popen(
        [sys.executable, "-c", program], stdin=theirs, stdout=theirs, stderr=theirs, env=env
    )
    os.close(theirs)
    os.write(ours, typed.encode())
    read = b""
    try:
        while part := os.read(ours, 65536):
            read += part
    except OSError:  # the terminal's other end is closed
        pass
    finally:
        os.close(ours)
        process.wait(timeout=60)
    return read.decode().replace("\r\n", "\n")
