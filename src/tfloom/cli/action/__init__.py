"""`action`: inspect actions, and send goals."""
