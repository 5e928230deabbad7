"""List the storages and compressions that bags may have."""

from __future__ import annotations

import argparse

KINDS = {
    "storage": {
        "mcap": "messages in chunks, which may be compressed, with indexes",
        "sqlite3": "messages in a table of a database",
    },
    "converter": {},
    "compressor": {"zstd": "compresses files, or each message"},
    "decompressor": {"zstd": "decompresses files, or each message"},
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag list`."""
    parser.add_argument("plugin_type", choices=list(KINDS), help="the kind to list")
    parser.add_argument("-v", "--verbose", action="store_true", help="print what each one does")


def main(args: argparse.Namespace) -> int:
    """Print the names of the storage plugins of one kind."""
    for name, text in KINDS[args.plugin_type].items():
        print(f"{name}: {text}" if args.verbose else name)
    return 0
