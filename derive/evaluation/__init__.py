"""Evaluates formulas: in floating point with a bound on its error, at many points at once, and to many digits."""
