"""The thresholds of the checks."""

from __future__ import annotations

from typing import NamedTuple


class Limits(NamedTuple):
    """What the checks take for sound."""

    min_rate_hz: float = 5.0
    max_gap_s: float = 0.5
    """A longer time without a transform is a gap, if it is `GAP_PERIODS` mean periods as well."""
    max_jitter: float = 0.4
    """Standard deviation of the period, in means of it, without the longest one."""
    max_ahead_s: float = 0.1
    max_skew_s: float = 0.2
    max_jump_m: float = 1.0
    """A longer step from one transform to the next is a teleport, if it is faster than `max_speed_m_s` and sudden."""
    max_speed_m_s: float = 10.0
    max_turn_deg: float = 60.0
    """A wider turn from one transform to the next is a teleport, if it is faster than `MAX_SPIN_DEG_S` and sudden."""
    max_norm_error: float = 1e-3
    """Of a quaternion: | |q| - 1 |."""


GAP_PERIODS = 5.0
"""A gap is at least as long as this number of mean periods."""
MIN_JITTER_S = 0.02
"""A standard deviation of the period below this is not jitter, because a host's scheduling causes it."""
MAX_SPIN_DEG_S = 180.0
MIN_COUNT = 8
"""The number of transforms from which a statistic says something."""
