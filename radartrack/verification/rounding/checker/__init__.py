"""The checker of certificates: in every box it derives the bound again, in ball arithmetic, by rules of its own."""
