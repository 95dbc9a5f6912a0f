"""Derivations: what is measured, how the rest follows, and how it is written and checked. SymPy only."""
