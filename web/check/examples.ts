/** Questions to click, each of another kind. */

import type { Question } from "./question";

const none = { given: {}, let: {} };

export const EXAMPLES: [string, Question][] = [
  [
    "An unbiased estimate with the wrong sign",
    { ...none, quantity: "polar.unbiased.estimate[0]", formula: "r*cos(beta)*(1 - sigma_beta^2/2)", notation: "text", given: { rho: "0" } },
  ],
  [
    "A covariance in a paper's own letters",
    { ...none, quantity: "polar.covariance.linear[0,1]", formula: "\\tfrac12\\left(\\sigma_r^2-r^2\\sigma_\\theta^2\\right)\\sin 2\\theta", notation: "latex", given: { rho: "0" } },
  ],
  [
    "Variances for deviations, by a definition",
    { quantity: "polar.bias.second_order[0]", formula: "-D*r*cos(beta)/2", notation: "text", given: { rho: "0" }, let: { D: "sigma_beta^2" } },
  ],
  [
    "A Jacobian with an entry that slipped",
    { ...none, quantity: "polar.jacobian", formula: "\\begin{pmatrix} \\cos\\beta & -r\\sin\\beta \\\\ \\sin\\beta & r\\sin\\beta \\end{pmatrix}", notation: "latex" },
  ],
  [
    "What a Doppler radar sees, in Python",
    { ...none, quantity: "observe.polar_doppler.map", formula: "[math.hypot(x, y), math.atan2(y, x), (x*vx + y*vy)/math.hypot(x, y)]", notation: "python" },
  ],
  [
    "Which quantity is this?",
    { ...none, quantity: "", formula: "\\frac{T^3}{3} q", notation: "latex" },
  ],
];
