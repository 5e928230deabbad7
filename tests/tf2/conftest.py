"""Random cases without limits of time, which a busy machine, an emulator, or a slower build of Python would miss."""

from __future__ import annotations

from hypothesis import HealthCheck, settings

if settings().deadline is not None:  # with CI, Hypothesis has chosen a profile without them
    settings.register_profile("patient", deadline=None, suppress_health_check=[HealthCheck.too_slow])
    settings.load_profile("patient")
