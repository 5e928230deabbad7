"""Why a lookup of a transform succeeds or fails: the chain, its time, its publishers, and what to do."""
