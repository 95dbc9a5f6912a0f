"""What sites see together, and where they stand."""
