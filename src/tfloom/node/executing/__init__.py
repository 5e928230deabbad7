"""Running of callbacks: entities, callback groups, tasks, timers, waitables, executors, signals."""
