"""Passes velocity commands on, unless an obstacle is ahead or the commands have ended."""
