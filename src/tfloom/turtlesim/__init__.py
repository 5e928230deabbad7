"""Turtles that draw: their world, its picture, and the programs around it."""
