"""Demonstration nodes for events of publishers and subscriptions."""
