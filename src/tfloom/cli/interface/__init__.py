"""`interface`: definitions of messages, services and actions."""
