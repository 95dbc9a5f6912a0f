"""Taylor expansion of a map: Jacobian, Hessian, and the moments of its linear and quadratic polynomials."""

from __future__ import annotations

from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

Matrix = Sequence[Sequence[Expr]]


def jacobian(outputs: Tensor[Expr], variables: Sequence[Symbol]) -> Tensor[Expr]:
    """∂h_a/∂θ_i, shape [out, in]."""
    return Tensor.build((len(outputs.entries), len(variables)), lambda a, i: sp.diff(outputs[a,], variables[i]))


def hessian(outputs: Tensor[Expr], variables: Sequence[Symbol]) -> Tensor[Expr]:
    """∂²h_a/∂θ_i∂θ_j, shape [out, in, in]."""
    size = len(variables)
    return Tensor.build(
        (len(outputs.entries), size, size), lambda a, i, j: sp.diff(outputs[a,], variables[i], variables[j])
    )


def second_order_bias(outputs: Tensor[Expr], variables: Sequence[Symbol], covariance: Matrix) -> Tensor[Expr]:
    """½ Σ K_ij ∂²h_a/∂θ_i∂θ_j = L h, shape [out]; Prosov (7)."""
    curvature, size = hessian(outputs, variables), range(len(variables))
    return Tensor.build(
        outputs.shape,
        lambda a: sp.Add(*(covariance[i][j] * curvature[a, i, j] / 2 for i in size for j in size)),
    )


def linear_covariance(outputs: Tensor[Expr], variables: Sequence[Symbol], covariance: Matrix) -> Tensor[Expr]:
    """J K Jᵀ, shape [out, out]; Prosov (9), Gao (1)."""
    slope, size = jacobian(outputs, variables), range(len(variables))
    count = len(outputs.entries)
    return Tensor.build(
        (count, count),
        lambda a, b: sp.Add(*(slope[a, i] * covariance[i][j] * slope[b, j] for i in size for j in size)),
    )


def second_order_covariance(outputs: Tensor[Expr], variables: Sequence[Symbol], covariance: Matrix) -> Tensor[Expr]:
    """J K Jᵀ + ½ tr(G_a K G_b K), the covariance of the quadratic Taylor polynomial, shape [out, out]."""
    linear, curvature = linear_covariance(outputs, variables, covariance), hessian(outputs, variables)
    size = range(len(variables))

    def trace(a: int, b: int) -> Expr:
        products = (
            curvature[a, i, j] * covariance[j][k] * curvature[b, k, m] * covariance[m][i]
            for i in size
            for j in size
            for k in size
            for m in size
        )
        return sp.Add(*products)

    return Tensor.build(linear.shape, lambda a, b: linear[a, b] + trace(a, b) / 2)


def third_order_covariance(outputs: Tensor[Expr], variables: Sequence[Symbol], covariance: Matrix) -> Tensor[Expr]:
    """The covariance of the cubic Taylor polynomial, shape [out, out].

    In Hermite's polynomials of the errors, which are uncorrelated, the cubic T_ijk w_i w_j w_k/6 is one of them and
    K_ij T_ijk w_k/2. So this is the second-order covariance of the slopes (1 + L) J, and T_ijk T_mno K_im K_jn K_ko/6.
    """
    size = range(len(variables))
    mean = second_order_bias(outputs, variables, covariance)
    steeper = outputs.shape[0]
    slopes = Tensor.build(
        (steeper, len(variables)), lambda a, i: sp.diff(outputs[a,], variables[i]) + sp.diff(mean[a,], variables[i])
    )
    linear, quadratic = (of(outputs, variables, covariance) for of in (linear_covariance, second_order_covariance))
    third = {
        (a, i, j, k): sp.diff(outputs[a,], variables[i], variables[j], variables[k])
        for a in range(steeper)
        for i in size
        for j in size
        for k in size
    }

    def cubic(a: int, b: int) -> Expr:
        return sp.Add(
            *(
                third[a, i, j, k] * covariance[i][m] * covariance[j][n] * covariance[k][o] * third[b, m, n, o]
                for i in size
                for j in size
                for k in size
                for m in size
                for n in size
                for o in size
                if covariance[i][m] != 0 and covariance[j][n] != 0 and covariance[k][o] != 0
            )
        )

    def entry(a: int, b: int) -> Expr:
        along = sp.Add(*(slopes[a, i] * covariance[i][j] * slopes[b, j] for i in size for j in size))
        return along + quadratic[a, b] - linear[a, b] + cubic(a, b) / 6

    return Tensor.build(linear.shape, entry)
