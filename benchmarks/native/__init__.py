"""What each cleverness of the native code buys: with and without it, in the same run."""
