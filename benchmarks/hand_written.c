/*
 * Loops as one would write them by hand for polar plots. `unbiased_by_hand` has the same formulas as the generated
 * code, `unbiased_as_printed` those of the paper (Mo et al. 1998) for independent errors: one sine, one cosine and one
 * exponential a plot, and digits cancel.
 */
#include <math.h>
#include <stddef.h>

void unbiased_by_hand(size_t n, const double *r, const double *beta, const double *sigma_r, const double *sigma_beta,
                      const double *rho, double *mean, double *covariance)
{
    size_t i;
    for (i = 0; i < n; ++i) {
        const double c = cos(beta[i]), s = sin(beta[i]), v = sigma_beta[i] * sigma_beta[i];
        const double r_2 = r[i] * r[i], v_r = sigma_r[i] * sigma_r[i], k = rho[i] * sigma_beta[i] * sigma_r[i];
        const double e = exp(-0.5 * v), a = e * e, q = -expm1(-v), once = 1.0 / a, k_2 = k * k, a_3 = a * a * a;
        const double along = 0.5 * (2.0 + a) * r_2 * q * q * once + 0.5 * v_r * (1.0 + a * a) - 2.0 * a * a * k_2;
        const double across = k_2 * (1.0 + 2.0 * a + 2.0 * a_3) * once + (1.0 + a) * q * 0.5 * (r_2 + v_r);
        const double mixed =
            a * a * v_r - (r_2 * q * (a * (a - q) - q * q) + k_2 * (1.0 + 2.0 * a + 4.0 * a_3)) * once;
        const double turned = r[i] * k * (a * (a * (a - 3.0 * q) - 3.0 * q * q) - q * q * q) * once;
        mean[2 * i] = (r[i] * c + k * s) / e;
        mean[2 * i + 1] = (r[i] * s - k * c) / e;
        covariance[4 * i] = c * c * along + s * s * across - 2.0 * c * s * turned;
        covariance[4 * i + 1] = covariance[4 * i + 2] = c * s * mixed + (c * c - s * s) * turned;
        covariance[4 * i + 3] = s * s * along + c * c * across + 2.0 * c * s * turned;
    }
}

void unbiased_as_printed(size_t n, const double *r, const double *beta, const double *sigma_r,
                         const double *sigma_beta,
                         const double *rho, double *mean, double *covariance)
{
    size_t i;
    (void)rho;
    for (i = 0; i < n; ++i) {
        const double c = cos(beta[i]), s = sin(beta[i]), squared = r[i] * r[i];
        const double lambda = exp(-0.5 * sigma_beta[i] * sigma_beta[i]), lambda_2 = lambda * lambda;
        const double twice = 0.5 * (squared + sigma_r[i] * sigma_r[i]), lambda_4 = lambda_2 * lambda_2;
        const double less = (1.0 / lambda_2 - 2.0) * squared, cos_2 = c * c - s * s, sin_2 = 2.0 * s * c;
        mean[2 * i] = r[i] * c / lambda;
        mean[2 * i + 1] = r[i] * s / lambda;
        covariance[4 * i] = less * c * c + twice * (1.0 + lambda_4 * cos_2);
        covariance[4 * i + 1] = covariance[4 * i + 2] = less * c * s + twice * lambda_4 * sin_2;
        covariance[4 * i + 3] = less * s * s + twice * (1.0 - lambda_4 * cos_2);
    }
}
