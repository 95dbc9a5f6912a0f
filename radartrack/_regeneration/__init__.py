"""Derives everything, writes the generated modules and swaps them in, or compares them with the disk."""
