"""`multicast`: try whether multicast comes through."""
