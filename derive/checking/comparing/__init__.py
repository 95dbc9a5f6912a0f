"""Whether and where a printed formula differs from the derived one, by numbers."""
