"""`action`: ask about actions, and send goals."""
