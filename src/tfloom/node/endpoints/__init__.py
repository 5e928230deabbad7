"""Endpoints on the wire: publishers, subscriptions, services and clients."""
