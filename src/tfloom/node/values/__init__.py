"""Values and names that need no node: times, durations, names, types, handles, errors."""
