"""Sine, cosine and exponential as few operations: polynomials computed in many digits, reductions of arguments."""
