"""Proofs that the elementary functions are within one unit in the last place, and a campaign beside exact values."""
