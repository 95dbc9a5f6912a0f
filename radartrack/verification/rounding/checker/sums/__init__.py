"""Sums of products of powers: what they say of errors, signs and sizes in one box of the domain."""
