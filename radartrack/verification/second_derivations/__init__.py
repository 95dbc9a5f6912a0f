"""Every quantity derived a second time by other means, to compare with what the operator gives."""
