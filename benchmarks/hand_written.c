/*
 * The unbiased conversion of polar plots with independent errors as one would program it from print (Mo et al. 1998):
 * one sine, one cosine, one exponential a plot; and its covariance averaged over the truth (Lerro & Bar-Shalom 1993).
 * Digits cancel in both where errors are small.
 */
#include <math.h>
#include <stddef.h>

void unbiased_by_hand(size_t n, const double *r, const double *beta, const double *sigma_r, const double *sigma_beta,
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

void averaged_by_hand(size_t n, const double *r, const double *beta, const double *sigma_r, const double *sigma_beta,
                      const double *rho, double *mean, double *covariance)
{
    size_t i;
    (void)rho;
    for (i = 0; i < n; ++i) {
        const double c = cos(beta[i]), s = sin(beta[i]), r_2 = r[i] * r[i], v_r = sigma_r[i] * sigma_r[i];
        const double v_beta = sigma_beta[i] * sigma_beta[i], once = exp(-v_beta), twice = exp(-2.0 * v_beta);
        const double bias = once - exp(-0.5 * v_beta);
        const double ch = 0.5 * (1.0 / once + once), ch_2 = 0.5 * (1.0 / twice + twice);
        const double sh = 0.5 * (1.0 / once - once), sh_2 = 0.5 * (1.0 / twice - twice);
        const double even = r_2 * (ch_2 - ch) + v_r * (2.0 * ch_2 - ch);
        const double odd = r_2 * (sh_2 - sh) + v_r * (2.0 * sh_2 - sh), fourth = twice * twice;
        mean[2 * i] = r[i] * c * (1.0 - bias);
        mean[2 * i + 1] = r[i] * s * (1.0 - bias);
        covariance[4 * i] = twice * (c * c * even + s * s * odd);
        covariance[4 * i + 1] = covariance[4 * i + 2] = s * c * fourth * (v_r + (r_2 + v_r) * (1.0 - 1.0 / once));
        covariance[4 * i + 3] = twice * (s * s * even + c * c * odd);
    }
}
