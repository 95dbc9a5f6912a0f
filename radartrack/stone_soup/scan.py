"""The detections of a scan, sorted by what is measured."""

from collections.abc import Iterable
from typing import Any


def model_for(detection: Any, default: Any) -> Any:
    """The measurement model of a detection, or the one for all.

    Raises:
        ValueError: there is neither.

    """
    model = detection.measurement_model if detection.measurement_model is not None else default
    if model is None:
        raise ValueError("measurement_model must be given where a detection has none; got None for both")
    return model


def by_kind(detections: Iterable[Any], default: Any) -> list[list[Any]]:
    """Detections whose models are of one type together."""
    groups: dict[type, list[Any]] = {}
    for detection in detections:
        groups.setdefault(type(model_for(detection, default)), []).append(detection)
    return [*groups.values()]
