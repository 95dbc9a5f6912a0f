"""Rings in which equality is decidable, and the one place that proves two expressions to be the same function."""
