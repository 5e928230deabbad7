"""Write the façades, as `src/tfloom/ros_names/rclpy`, anew: `python -m tools.facades`."""

from __future__ import annotations

import sys

from tools.facades.generate import generate_all
from tools.facades.rooms import ROOT, write_differing
from tools.facades.table import TableError, read_table


def main() -> int:
    """Write each file that differs, remove those of modules that left the table, and return an exit code."""
    try:
        files = generate_all()
    except TableError as error:
        print(error, file=sys.stderr)
        return 1
    write_differing(files)
    for package, rows in read_table().items():
        for path in (ROOT / rows.folder / package).rglob("*.py"):
            name = path.relative_to(ROOT).as_posix()
            if name not in files:
                path.unlink()
                print(f"removed {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
