"""Nodes with a lifecycle: unconfigured, inactive, active, finalized."""
