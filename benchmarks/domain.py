"""The DDS domain of the benchmarks: ROS_DOMAIN_ID, or a domain that the tests do not use."""

from __future__ import annotations

import os

DOMAIN_ID = int(os.environ.get("ROS_DOMAIN_ID") or 99)
