"""Texts that are only known when the launch runs."""
