"""How a function of a user's is called: which parameter takes what, and what comes back of it."""
