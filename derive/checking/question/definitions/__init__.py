"""What names of a paper stand for: its definitions, and constants that everybody knows."""
