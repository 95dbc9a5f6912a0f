"""How quantities say in words what their errors are measured against."""

ITSELF = "itself"
WEIGHTS = "the weights of this, the first and the last scan and the root mean square of all"
