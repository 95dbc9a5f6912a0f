"""Moments of converted measurements: Taylor terms, and expectations by the operator e^L, exact or to an order."""
