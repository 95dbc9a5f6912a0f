"""Under which condition, in which other convention, or as which other quantity a formula is right."""
