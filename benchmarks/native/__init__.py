"""Measure the gain of each optimisation in the native code: with and without it, in the same run."""
