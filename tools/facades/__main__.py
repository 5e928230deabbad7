"""Write the façades in `src/tfloom/ros_names/` anew: `python -m tools.facades`."""

from __future__ import annotations

import sys

from tools.facades.generate import generate_all
from tools.facades.rooms import HOUSE
from tools.facades.table import TableError

FACADES = HOUSE / "ros_names"


def main() -> int:
    """Write each file that differs, remove those of modules that left the table, and return an exit code."""
    try:
        files = generate_all()
    except TableError as error:
        print(error, file=sys.stderr)
        return 1
    for name, text in files.items():
        path = FACADES / name
        if not path.is_file() or path.read_text("utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8")
            print(f"wrote {name}")
    for package in {name.split("/")[0] for name in files}:
        for path in (FACADES / package).rglob("*.py"):
            name = path.relative_to(FACADES).as_posix()
            if name not in files:
                path.unlink()
                print(f"removed {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
