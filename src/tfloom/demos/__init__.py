"""Example programs of the tutorials, and the demonstration.

- show: the demonstration, its programs as processes or on threads
"""
