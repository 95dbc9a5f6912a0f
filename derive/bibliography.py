"""The works that formulas are cited from, by key: the one place that knows titles and DOIs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from radartrack.derive.language.source import Source


@dataclass(frozen=True)
class Work:
    """A paper or a book.

    Attributes:
        author: the authors, as they are cited.
        year: of publication; None where it is not known.
        title: in English.
        published: journal, volume and pages, or the publisher.
        doi: where there is one.
    """

    author: str
    year: int | None
    title: str
    published: str = ""
    doi: str = ""


WORKS: Mapping[str, Work] = MappingProxyType(
    {
        "aitken1936": Work(
            "Aitken",
            1936,
            "On least squares and linear combination of observations",
            "Proceedings of the Royal Society of Edinburgh 55, 42-48",
            "10.1017/S0370164600014346",
        ),
        "barshalom1986": Work(
            "Bar-Shalom & Campo",
            1986,
            "The effect of the common process noise on the two-sensor fused-track covariance",
            "IEEE Transactions on Aerospace and Electronic Systems 22(6), 803-805",
            "10.1109/TAES.1986.310815",
        ),
        "barshalom1995": Work(
            "Bar-Shalom & Li",
            1995,
            "Multitarget-multisensor tracking: principles and techniques",
            "YBS Publishing",
        ),
        "barshalom2001": Work(
            "Bar-Shalom, Li & Kirubarajan",
            2001,
            "Estimation with applications to tracking and navigation",
            "Wiley",
            "10.1002/0471221279",
        ),
        "barshalom2011": Work(
            "Bar-Shalom, Willett & Tian",
            2011,
            "Tracking and data fusion: a handbook of algorithms",
            "YBS Publishing",
        ),
        "bordonaro2014": Work(
            "Bordonaro et al.",
            2014,
            "Decorrelated unbiased converted measurement Kalman filter",
            "IEEE Transactions on Aerospace and Electronic Systems 50(2), 1431-1444",
            "10.1109/TAES.2014.120563",
        ),
        "crouse2014": Work(
            "Crouse",
            2014,
            "Basic tracking using nonlinear 3D monostatic and bistatic measurements",
            "IEEE Aerospace and Electronic Systems Magazine 29(8), 4-53",
        ),
        "duan2004": Work(
            "Duan et al.",
            2004,
            "Comments on 'Unbiased converted measurements for tracking'",
            "IEEE Transactions on Aerospace and Electronic Systems 40(4), 1374-1377",
            "10.1109/TAES.2004.1386889",
        ),
        "duan2005": Work(
            "Duan et al.",
            2005,
            "Sequential unscented Kalman filter for radar target tracking with range rate measurements",
            "8th International Conference on Information Fusion",
        ),
        "gao2020": Work(
            "Gao et al.",
            2020,
            "Two methods for calculating the variance of radar measurements in the Cartesian coordinate",
            "Spacecraft Environment Engineering 37(2), 179-183",
            "10.12126/see.2020.02.013",
        ),
        "gauss1809": Work("Gauss", 1809, "Theory of the motion of the heavenly bodies", "Perthes & Besser"),
        "gauss1823": Work(
            "Gauss", 1823, "Theory of the combination of observations least subject to errors", "Dieterich"
        ),
        "gorshkov": Work(
            "Gorshkov & Zavizhenets",
            None,
            "Filtering of polynomial trajectories of manoeuvring targets over a finite sample with range rate",
        ),
        "hofmannwellenhof2006": Work(
            "Hofmann-Wellenhof & Moritz",
            2006,
            "Physical geodesy",
            "Springer",
            "10.1007/978-3-211-33545-1",
        ),
        "julier1997": Work(
            "Julier & Uhlmann",
            1997,
            "A non-divergent estimation algorithm in the presence of unknown correlations",
            "Proceedings of the American Control Conference, 2369-2373",
            "10.1109/ACC.1997.609105",
        ),
        "kalata1984": Work(
            "Kalata",
            1984,
            "The tracking index: a generalized parameter for alpha-beta and alpha-beta-gamma target trackers",
            "IEEE Transactions on Aerospace and Electronic Systems 20(2), 174-182",
            "10.1109/TAES.1984.310438",
        ),
        "leone1961": Work(
            "Leone et al.", 1961, "The folded normal distribution", "Technometrics 3(4), 543-550", "10.2307/1266560"
        ),
        "lerro1993": Work(
            "Lerro & Bar-Shalom",
            1993,
            "Tracking with debiased consistent converted measurements versus EKF",
            "IEEE Transactions on Aerospace and Electronic Systems 29(3), 1015-1022",
            "10.1109/7.220948",
        ),
        "mo1998": Work(
            "Mo et al.",
            1998,
            "Unbiased converted measurements for tracking",
            "IEEE Transactions on Aerospace and Electronic Systems 34(3), 1023-1027",
            "10.1109/7.705921",
        ),
        "morrison1969": Work("Morrison", 1969, "Introduction to sequential smoothing and prediction", "McGraw-Hill"),
        "pearson1901": Work(
            "Pearson",
            1901,
            "On lines and planes of closest fit to systems of points in space",
            "Philosophical Magazine 2(11), 559-572",
            "10.1080/14786440109462720",
        ),
        "prosov": Work(
            "Prosov",
            None,
            "Analysis of the effect of linearisation of radar measurements on the accuracy of target state estimates",
        ),
        "willis1991": Work("Willis", 1991, "Bistatic radar", "Artech House"),
        "singer1970": Work(
            "Singer",
            1970,
            "Estimating optimal tracking filter performance for manned maneuvering targets",
            "IEEE Transactions on Aerospace and Electronic Systems 6(4), 473-483",
            "10.1109/TAES.1970.310128",
        ),
        "uhlenbeck1930": Work(
            "Uhlenbeck & Ornstein",
            1930,
            "On the theory of the Brownian motion",
            "Physical Review 36(5), 823-841",
            "10.1103/PhysRev.36.823",
        ),
    }
)


def cite(key: str, where: str = "", *also: Source) -> Source:
    """A place in a work of the bibliography, and other sources that print the same.

    Raises:
        KeyError: when the bibliography has no such work.
    """
    if key not in WORKS:
        raise KeyError(f"key must be one of {', '.join(WORKS)}; given {key!r}")
    work = WORKS[key]
    return Source(work.author, work.year, where, work.doi, also)
