"""What is it called: a quantity found by words, by its formula, or by the equations of a whole paper."""
