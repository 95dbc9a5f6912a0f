"""Verbs that a formula may use beside functions: sums, integrals, limits, derivatives, matrices, expectations.

Each is exact within what can be decided, and says what was too much for it.
"""
