"""Presets and configuration files of the storages, as rosbag2's plugins have them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.writing.storage import StorageSettings

__all__ = ["PRESETS", "storage_settings"]

PRESETS: dict[str, dict[str, StorageSettings]] = {
    "mcap": {
        "none": StorageSettings(),
        "fastwrite": StorageSettings(is_chunked=False, has_message_index=False),
        "zstd_fast": StorageSettings(compression="zstd", level="Fastest"),
        "zstd_small": StorageSettings(compression="zstd", level="Slowest", chunk_size=4 * 1024 * 1024),
    },
    "sqlite3": {
        "none": StorageSettings(),
        "resilient": StorageSettings(pragmas=("synchronous=NORMAL",)),
    },
}
"""By storage and name."""

_ACCEPTED = {
    *("noAttachmentCRC", "enableDataCRC", "noRepeatedSchemas", "noRepeatedChannels", "noAttachmentIndex"),
    *("noMetadataIndex", "noChunkIndex", "noStatistics", "noSummaryOffsets", "forceCompression"),
}
"""Options of the mcap library that are accepted and have no effect here."""
_LEVELS = ("Fastest", "Fast", "Default", "Slow", "Slowest")
_COMPRESSIONS = {"none": "", "lz4": "lz4", "zstd": "zstd"}


def storage_settings(storage_id: str, preset: str = "", config_file: str = "") -> StorageSettings:
    """Return the settings of a preset, changed by those of a file.

    Args:
        storage_id: `mcap` or `sqlite3`.
        preset: A name in `PRESETS`; empty: none.
        config_file: A YAML file; empty: none.

    Raises:
        BagError: the storage has no such preset, or the file can't be read or has an unknown value.
    """
    presets = PRESETS[storage_id]
    if (preset or "none") not in presets:
        raise BagError(
            config_file or storage_id, f"'{preset}' is not a preset of {storage_id}: {', '.join(presets)}"
        )
    settings = presets[preset or "none"]
    if not config_file:
        return settings
    values = _read(Path(config_file))
    change = _sqlite_settings if storage_id == "sqlite3" else _mcap_settings
    try:
        return change(settings, values)
    except (ValueError, TypeError, AttributeError) as error:
        raise BagError(
            config_file, f"this can't be used as a configuration of {storage_id}: {error}"
        ) from None


def _read(path: Path) -> dict[str, Any]:
    from tfloom.common import yaml as user_yaml

    try:
        values = user_yaml.load(path.read_text("utf-8")) or {}
    except OSError as error:
        raise BagError(path, f"it can't be read: {error.strerror}") from None
    except (user_yaml.YamlError, UnicodeDecodeError) as error:
        raise BagError(path, f"it isn't YAML: {error}") from None
    if not isinstance(values, dict):
        raise BagError(path, "it must be a map from options to values")
    return values


def _mcap_settings(settings: StorageSettings, values: Mapping[str, Any]) -> StorageSettings:
    changes: dict[str, Any] = {}
    for name, value in values.items():
        if name in _MCAP:
            field, convert = _MCAP[name]
            changes[field] = convert(value)
        elif name not in _ACCEPTED:
            raise ValueError(f"unknown option {name}")
    return settings._replace(**changes)


def _sqlite_settings(settings: StorageSettings, values: Mapping[str, Any]) -> StorageSettings:
    pragmas = (values.get("write") or {}).get("pragmas") or []
    for pragma in pragmas:
        if not isinstance(pragma, str) or ";" in pragma:
            raise ValueError(f"no pragma: {pragma!r}")
    return settings._replace(pragmas=(*settings.pragmas, *pragmas))


def _not(value: Any) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"true or false is expected, not {value!r}")
    return not value


def _size(value: Any) -> int:
    if not isinstance(value, int) or value < 1:
        raise ValueError(f"a positive number of bytes is expected, not {value!r}")
    return value


def _compression(value: Any) -> str:
    if str(value).lower() not in _COMPRESSIONS:
        raise ValueError(f"compression is None, Lz4 or Zstd, not {value!r}")
    return _COMPRESSIONS[str(value).lower()]


def _level(value: Any) -> str:
    if value not in _LEVELS:
        raise ValueError(f"compressionLevel is one of {', '.join(_LEVELS)}, not {value!r}")
    return str(value)


_MCAP: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "noChunkCRC": ("has_chunk_crc", _not),
    "noChunking": ("is_chunked", _not),
    "noMessageIndex": ("has_message_index", _not),
    "noSummary": ("has_summary", _not),
    "chunkSize": ("chunk_size", _size),
    "compression": ("compression", _compression),
    "compressionLevel": ("level", _level),
}
"""By option: the field, and what converts the value to the field's."""
