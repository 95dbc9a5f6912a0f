"""What the letters of a paper stand for, where they are not those of the quantity."""
