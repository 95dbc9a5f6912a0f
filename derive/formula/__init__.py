"""A printed formula as a tree: its nodes, walks over it, its way to algebra and back, and how it is printed."""
