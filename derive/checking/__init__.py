"""Checks printed formulas and claims against what was derived."""
