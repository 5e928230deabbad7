"""Record topics and services into a bag."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.cli.bag import conventions
from tfloom.cli.parser import help_since
from tfloom.cli.shared import numbers
from tfloom.common.terminal import report
from tfloom.ros_imports.ros_distro import ALL_RECORDS_ACTIONS, LOSSES_HZ, removal

if TYPE_CHECKING:
    from tfloom.bag.recording.recorded_topics import RecordOptions
    from tfloom.bag.writing.bag_writer import WriterSettings

PRESETS = ["none", "fastwrite", "zstd_fast", "zstd_small"]
"""The presets of mcap, which the usage lists; sqlite3 has the first one, and `SQLITE3_PRESET`."""
SQLITE3_PRESET = "resilient"
DEFAULT_CACHE_SIZE = 100 * 1024 * 1024


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag record`."""
    parser.add_argument(
        "topics_positional", nargs="*", metavar="[Topic ...]", help="topics to record; --topics is preferred"
    )
    parser.add_argument(
        "-o", "--output", help="folder of the bag (default: rosbag2_ and the time, in the current folder)"
    )
    parser.add_argument(
        "-s",
        "--storage",
        choices=conventions.STORAGES,
        default="mcap",
        help="storage of the bag (default: mcap)",
    )
    _add_choice(parser)
    _add_discovery(parser)
    _add_writing(parser)
    _add_node(parser)
    _add_storage(parser)


def _add_choice(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--topics", nargs="+", default=[], metavar="Topic", help="topics to record")
    add("--services", nargs="+", default=[], metavar="ServiceName", help="services whose events are recorded")
    add(
        "--actions",
        nargs="+",
        default=[],
        metavar="ActionName",
        help=help_since("kilted", "actions to record: feedback, status, events"),
    )
    add("--topic-types", nargs="+", default=[], metavar="TopicType", help="types whose topics are recorded")
    add(
        "-a",
        "--all",
        action="store_true",
        help="record all topics and services, but for hidden topics; from Kilted on all actions, too",
    )
    add("--all-topics", action="store_true", help="record all topics, but for hidden ones")
    add("--all-services", action="store_true", help="record the events of all services")
    add("--all-actions", action="store_true", help=help_since("kilted", "record all actions"))
    add(
        "-e",
        "--regex",
        default="",
        type=conventions.regular_expression,
        help="record topics and services in whose names this is found",
    )
    add(
        "--exclude-regex",
        default="",
        type=conventions.regular_expression,
        help="leave out topics and services in whose names this is found",
    )
    add(
        "--exclude-topic-types", nargs="+", default=[], metavar="ExcludeTopicTypes", help="types to leave out"
    )
    add("--exclude-topics", nargs="+", default=[], metavar="Topic", help="topics to leave out")
    add("--exclude-services", nargs="+", default=[], metavar="ServiceName", help="services to leave out")
    add(
        "--exclude-actions",
        nargs="+",
        default=[],
        metavar="ActionName",
        help=help_since("kilted", "actions to leave out"),
    )


def _add_discovery(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--include-unpublished-topics", action="store_true", help="record topics without a publisher too")
    add("--include-hidden-topics", action="store_true", help="record hidden topics too")
    add(
        "--static-topics-path",
        type=conventions.existing_file,
        help=help_since(
            "lyrical",
            "YAML file with topics and their types, which are recorded from the start: "
            "static_topics_and_types_list: [[/topic, package/msg/Type], …]",
        ),
    )
    add("--no-discovery", action="store_true", help="record only topics that exist at the start")
    add(
        "-p",
        "--polling-interval",
        type=numbers.count,
        default=100,
        help="time between two looks at the graph in milliseconds (default 100)",
    )
    add("--ignore-leaf-topics", action="store_true", help="leave out topics without a subscription")
    add(
        "--qos-profile-overrides-path",
        type=conventions.existing_file,
        help="YAML file with a QoS profile for each topic whose own isn't wanted",
    )


def _add_writing(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("-f", "--serialization-format", default="", metavar="{}", help="cdr, the format of the wire")
    add(
        "-b",
        "--max-bag-size",
        type=numbers.size,
        default=0,
        help="size in bytes at which a file is completed and the next one begun (default 0: never)",
    )
    add(
        "-d",
        "--max-bag-duration",
        type=numbers.size,
        default=0,
        help="seconds after which a file is completed and the next one begun (default 0: never)",
    )
    add(
        "--max-bag-files",
        type=numbers.count,
        default=0,
        help=help_since(
            "lyrical",
            "number of files that are kept: the oldest is deleted when one more begins (default 0: all)",
        ),
    )
    add(
        "--max-cache-size",
        type=numbers.size,
        default=DEFAULT_CACHE_SIZE,
        help="size in bytes of each of two caches; what doesn't fit in is dropped and counted (default "
        f"{DEFAULT_CACHE_SIZE}, and for 0)",
    )
    add(
        "--max-cache-duration",
        type=numbers.count,
        default=0,
        help=help_since(
            "lyrical",
            "in snapshot mode, how many seconds a snapshot goes back at most (default 0: as far as the cache)",
        ),
    )
    add(
        "--repeat-transient-local",
        nargs="+",
        default=[],
        metavar="Topic[=Depth]",
        help=help_since(
            "lyrical",
            "topics with whose last message, or so many, each further file and each snapshot begins",
        ),
    )
    add(
        "--repeat-all-transient-local",
        type=numbers.count,
        default=0,
        metavar="Depth",
        help=help_since(
            "lyrical", "the same for all topics whose publishers are transient local (default 0: none)"
        ),
    )


def _add_node(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--disable-keyboard-controls", action="store_true", help="ignore the keyboard")
    add("--start-paused", action="store_true", help="begin in the paused state")
    add("--use-sim-time", action="store_true", help="stamp messages with the time of /clock")
    add("--node-name", default="rosbag2_recorder", help="name of the node (default rosbag2_recorder)")
    add(
        "--stats_max_publishing_rate",
        "--stats-max-publishing-rate",
        type=numbers.tolerance,
        default=LOSSES_HZ,
        help=help_since(
            "lyrical",
            "how often events/rosbag2_messages_lost says at most which messages were lost, in hertz; 0: never "
            "(default 1)",
        ),
    )
    add("--custom-data", nargs="*", metavar="KEY=VALUE", help="values for the metadata of the bag")
    add(
        "--snapshot-mode",
        action="store_true",
        help="keep the newest messages in the cache, and write them when the service ~/snapshot is called",
    )
    add("--log-level", choices=conventions.LOG_LEVELS, default="info", help="least level of what is printed")


def _add_storage(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "--storage-config-file",
        type=conventions.existing_file,
        help="YAML file with options of the storage",
    )
    add(
        "--storage-preset-profile",
        choices=[*PRESETS, SQLITE3_PRESET],
        metavar=f"{{{','.join(PRESETS)}}}",
        default="none",
        help="options of mcap: fastwrite has no chunks, zstd_fast and zstd_small compress them; of sqlite3: resilient "
        "loses less on a power cut",
    )
    add(
        "--compression-queue-size",
        type=numbers.count,
        default=1,
        help="accepted and not used: nothing is dropped before it is compressed",
    )
    add(
        "--compression-threads",
        type=numbers.whole,
        default=0,
        help="accepted and not used: one thread compresses",
    )
    add("--compression-threads-priority", type=numbers.whole, default=0, help="accepted and not used")
    add(
        "--compression-mode",
        choices=["none", "file", "message"],
        default="none",
        help="what is compressed (default: none)",
    )
    add("--compression-format", choices=["zstd"], default="", help="format of the compression")


def main(args: argparse.Namespace) -> int:
    """Check the folder and the settings, and record until Ctrl-C."""
    folder = _checked_folder(args)

    with conventions.explained():
        settings, options = _settings(args), _options(args)
        with conventions.running_context(args.log_level):
            from tfloom.bag.recording.run import record

            record(folder, settings, options, node_name=args.node_name, learn=conventions.learn_type)
    return 0


def _checked_folder(args: argparse.Namespace) -> Path:
    """Return the bag's folder.

    Raises:
        CommandError: the flags contradict one another, or the folder exists.
    """
    if args.topics_positional and (text := removal("topics of `ros2 bag record` without an option")):
        report(text)
    wanted = (
        *(args.all, args.all_topics, args.all_services, args.topics, args.topics_positional),
        *(args.services, args.actions, args.all_actions, args.topic_types, args.regex),
        args.static_topics_path,
    )
    if not any(wanted):
        raise conventions.error(
            "Need to specify at least one option out of --all, --all-topics, --all-services, --services, --topics, "
            "--topic-types or --regex"
        )
    if args.serialization_format not in {"", "cdr"}:
        raise conventions.error(
            f"'{args.serialization_format}' is not known here; the serialization format is cdr"
        )
    if args.max_bag_files and not (args.max_bag_size or args.max_bag_duration):
        raise conventions.error(
            "--max-bag-files needs --max-bag-size or --max-bag-duration, at which a file is completed"
        )
    if args.max_cache_duration and not args.snapshot_mode:
        raise conventions.error(
            "--max-cache-duration needs --snapshot-mode: what is written at once is in no cache"
        )
    if args.compression_format and args.compression_mode == "none":
        raise conventions.error(
            "Invalid choice: Cannot specify compression format without a compression mode."
        )
    if args.compression_mode != "none" and not args.compression_format:
        raise conventions.error(
            "Invalid choice: Compression format must be specified: --compression-format zstd"
        )
    owner = "sqlite3" if args.storage_preset_profile == SQLITE3_PRESET else "mcap"
    if args.storage_preset_profile != "none" and args.storage != owner:
        raise conventions.error(
            f"'{args.storage_preset_profile}' is a preset of {owner}, not of {args.storage}"
        )
    import datetime as dt

    stamp = dt.datetime.now()  # noqa: DTZ005 - the user's own time
    folder = Path(args.output or f"rosbag2_{stamp:%Y_%m_%d-%H_%M_%S}")
    if folder.exists():
        raise conventions.error(f"Output folder '{folder}' already exists.")
    return folder


def _settings(args: argparse.Namespace) -> WriterSettings:
    from tfloom.bag.writing.bag_writer import WriterSettings
    from tfloom.bag.writing.storage_config import storage_settings

    custom = {}
    for word in args.custom_data or []:
        key, equals, value = word.partition("=")
        if not equals:
            raise conventions.error(f"--custom-data needs KEY=VALUE, not '{word}'")
        custom[key] = value
    return WriterSettings(
        storage_id=args.storage,
        storage=storage_settings(args.storage, args.storage_preset_profile, args.storage_config_file or ""),
        max_file_size=args.max_bag_size,
        max_file_duration_ns=args.max_bag_duration * 1_000_000_000,
        max_files=args.max_bag_files,
        cache_size=args.max_cache_size,
        compression_mode="" if args.compression_mode == "none" else args.compression_mode.upper(),
        custom_data=custom,
        is_snapshot=args.snapshot_mode,
        snapshot_duration_ns=args.max_cache_duration * 1_000_000_000,
    )


def _options(args: argparse.Namespace) -> RecordOptions:
    from tfloom.bag.qos_profiles import read_overrides
    from tfloom.bag.recording.recorded_topics import RecordOptions
    from tfloom.bag.topic_choice import TopicChoice, full_names, read_static_topics

    choice = TopicChoice(
        topics=full_names([*args.topics_positional, *args.topics]),
        topic_types=args.topic_types,
        services=full_names(args.services),
        actions=full_names(args.actions),
        all_actions=args.all_actions or (args.all and ALL_RECORDS_ACTIONS),
        all_topics=args.all or args.all_topics,
        all_services=args.all or args.all_services,
        regex=args.regex,
        exclude_regex=args.exclude_regex,
        exclude_topics=full_names(args.exclude_topics),
        exclude_topic_types=args.exclude_topic_types,
        exclude_services=full_names(args.exclude_services),
        exclude_actions=full_names(args.exclude_actions),
    )
    overrides = args.qos_profile_overrides_path
    return RecordOptions(
        choice=choice,
        is_discovery_disabled=args.no_discovery,
        polling_interval_s=max(args.polling_interval, 1) / 1e3,
        include_hidden_topics=args.include_hidden_topics,
        include_unpublished_topics=args.include_unpublished_topics,
        ignore_leaf_topics=args.ignore_leaf_topics,
        qos_overrides=read_overrides(overrides) if overrides else {},
        is_start_paused=args.start_paused,
        use_sim_time=args.use_sim_time,
        has_keyboard=not args.disable_keyboard_controls,
        static_topics=read_static_topics(Path(args.static_topics_path)) if args.static_topics_path else {},
        losses_hz=args.stats_max_publishing_rate,
        repeated=_depths(args.repeat_transient_local),
        repeats_all=args.repeat_all_transient_local,
    )


def _depths(words: list[str]) -> dict[str, int]:
    """Return the numbers of messages that are repeated, by topic, of words such as `/map=3`.

    Raises:
        CommandError: a word isn't one.
    """
    from tfloom.bag.topic_choice import full_names

    depths = {}
    for word in words:
        topic, sign, depth = word.partition("=")
        if not topic or (sign and not (depth.isdecimal() and int(depth))):
            raise conventions.error(f"--repeat-transient-local needs Topic or Topic=Depth, not '{word}'")
        depths[full_names([topic])[0]] = int(depth or 1)
    return depths
