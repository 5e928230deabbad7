"""Values and names that know no node: times, durations, names, types, handles, errors."""
