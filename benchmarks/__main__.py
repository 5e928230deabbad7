"""Run the benchmarks of the named rooms, or of all. Each room is a package here with a `__main__.py`."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent


def main() -> int:
    rooms = sorted(path.parent.name for path in HERE.glob("*/__main__.py"))
    requested = sys.argv[1:] or rooms
    if unknown := [room for room in requested if room not in rooms]:
        print(f"no benchmarks of {', '.join(unknown)}; there are: {', '.join(rooms)}", file=sys.stderr)
        return 2
    for room in requested:
        print(f"== {room}", flush=True)
        subprocess.run([sys.executable, "-m", f"benchmarks.{room}"], cwd=HERE.parent, check=True)
    return 0


sys.exit(main())
