"""Where benchmarks meet: ROS_DOMAIN_ID, or a domain that the tests don't use."""

from __future__ import annotations

import os

DOMAIN_ID = int(os.environ.get("ROS_DOMAIN_ID") or 99)
