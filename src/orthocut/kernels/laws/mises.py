"""Numbers of the yield surface of von Mises."""

import math

ROOT_2_3 = math.sqrt(2.0 / 3.0)
"""Norm of the deviatoric stress over the yield stress in tension; plastic strain over plastic multiplier."""
