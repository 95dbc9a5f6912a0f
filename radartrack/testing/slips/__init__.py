"""What slip a function has, by its values alone: in a formula, in what it takes, in the matrices that it multiplies."""
