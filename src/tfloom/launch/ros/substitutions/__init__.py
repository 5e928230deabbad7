"""Substitutions by packages and parameters."""
