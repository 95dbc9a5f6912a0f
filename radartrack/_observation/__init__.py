"""Observation of states: what each sensor measures of which state, and where that has no derivative."""
