"""Where the lines of a launch go: the screen, the launch's log folder, and a process's own files.

- logging: loggers;  log_handlers, background_writing: what writes their lines, by threads while a launch runs
- library_handlers: the handlers of the standard library, with a format for single loggers
- terminal_colors: colors of a level, and of each process
"""
