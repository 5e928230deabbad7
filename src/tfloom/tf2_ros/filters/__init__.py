"""Message filters: messages held until their transform is there, and messages of several topics by their stamps."""
