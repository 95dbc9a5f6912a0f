/* A covariance in single precision: as it is printed, and as it is derived. */
#include <math.h>
#include <stdio.h>

#include "radartrack.h"

static void printed(float r, float beta, float sigma_r, float sigma_beta, float result[4])
{
    const float lambda = expf(-0.5f * sigma_beta * sigma_beta);
    const float lambda_4 = lambda * lambda * lambda * lambda;
    const float first = (1.0f / (lambda * lambda) - 2.0f) * r * r;
    const float second = 0.5f * (r * r + sigma_r * sigma_r);
    result[0] = first * cosf(beta) * cosf(beta) + second * (1.0f + lambda_4 * cosf(2.0f * beta));
    result[1] = first * cosf(beta) * sinf(beta) + second * lambda_4 * sinf(2.0f * beta);
    result[2] = result[1];
    result[3] = first * sinf(beta) * sinf(beta) + second * (1.0f - lambda_4 * cosf(2.0f * beta));
}

static void say(const char *what, double xx, double xy, double yy)
{
    const double middle = 0.5 * (xx + yy), apart = hypot(0.5 * (xx - yy), xy);
    printf("%-17s %7.0f %7.0f %7.0f   %s\n", what, xx, xy, yy, middle < apart ? "indefinite" : "positive definite");
}

int main(void)
{
    double exact[4];
    float ours[4], theirs[4];
    radartrack_polar_unbiased_covariance(100e3, 0.5, 20.0, 1e-3, 0.0, exact);
    radartrack_polar_unbiased_covariancef(100e3f, 0.5f, 20.0f, 1e-3f, 0.0f, ours);
    printed(100e3f, 0.5f, 20.0f, 1e-3f, theirs);
    printf("variances, m^2         x      xy       y\n");
    say("double", exact[0], exact[1], exact[3]);
    say("float, derived", (double)ours[0], (double)ours[1], (double)ours[3]);
    say("float, as printed", (double)theirs[0], (double)theirs[1], (double)theirs[3]);
    return 0;
}
