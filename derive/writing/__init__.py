"""Writes what was derived: NumPy modules, conversions and their loops, the formula book, single formulas."""
