"""What a check says: verdicts as data, and derived formulas as short ones."""
