"""NumPy functions written from the derivations; see the docstring of each for source and accuracy."""
