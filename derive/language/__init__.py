"""What can be said of a measurement: symbols with units and domains, tensors, quantities, models."""
