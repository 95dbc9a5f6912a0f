"""Fusion beyond independent errors: correlated tracks, unknown correlations, and biases of radars."""
