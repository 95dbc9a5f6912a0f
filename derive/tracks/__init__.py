"""Straight lines through tracks, the errors they show, and the fusion of several radars."""
