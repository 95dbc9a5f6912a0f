"""A paper as its author typed it, for the tests of drafts."""

PAPER = r"""
\documentclass{article}\title{On \emph{converted} measurements}
\begin{document}
\begin{equation}\label{eq:lambda} \lambda = e^{-\sigma_\theta^2/2} \end{equation}
\begin{align} x &= \rho\cos\theta, \nonumber \\ y &= \rho\sin\theta. \label{eq:y} \end{align}
\[ b_x = \rho\lambda\cos\theta - \rho\cos\theta \tag{8b} \]
% \begin{equation} commented = 1 \end{equation}
\begin{equation} Q_{11} = \frac{q T^3}{3} \end{equation}
\begin{equation*} w = \alpha\beta\gamma + \delta^7 \end{equation*}
$$ A = \begin{bmatrix} 1 & T \\ 0 & 1 \end{bmatrix} $$
"""
