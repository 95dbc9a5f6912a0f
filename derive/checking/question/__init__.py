"""What is asked: a printed formula, what it is compared with, under which conditions, and in which units."""
