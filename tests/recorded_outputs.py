"""What commands of a real ROS 2 Jazzy printed: `golden/cli`, a file for each group of commands."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

FOLDER = Path(__file__).parent / "golden" / "cli"


def recorded_output(name: str) -> str:
    """Return what is recorded below the heading `#### name`, in most cases a command line, its output and exit code."""
    return _outputs()[name]


@lru_cache(maxsize=1)
def _outputs() -> dict[str, str]:
    outputs: dict[str, str] = {}
    for path in sorted(FOLDER.iterdir()):
        _, *parts = re.split(r"^#### (\w+)\n", path.read_text("utf-8"), flags=re.MULTILINE)
        for name, text in zip(parts[::2], parts[1::2], strict=True):
            assert name not in outputs, f"{path.name}: {name} is recorded twice"
            outputs[name] = text
    return outputs
