"""Conditions: whether an action is executed."""
