"""Plug-ins of the command: commands and verbs that installed packages add by entry points."""
