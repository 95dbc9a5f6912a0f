"""Monte Carlo: which experiment a quantity is the mean of, its draws, and what follows from their sums."""
