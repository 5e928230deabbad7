"""Driving robots from pages: each is stopped when its page is closed or silent, and when the viewer has ended.

- driver: the velocities, and the time at which each ends
- process: the separate process in which a driver runs
- link: the viewer's side of it
"""
