"""Rewrites formulas so that nothing cancels when they are computed in floating point; each form is proved equal."""
