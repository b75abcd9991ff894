"""Colours: one quantity, one colour in every figure (Okabe and Ito's set, safe for colour-blind readers)."""

BLUE, ORANGE, GREEN, PURPLE = "#0072B2", "#D55E00", "#009E73", "#CC79A7"
AMBER, SKY, YELLOW, BLACK, GREY = "#E69F00", "#56B4E9", "#F0E442", "#000000", "#8C8C8C"

QUANTITY = {
    "force_cutting": BLUE,
    "force_thrust": ORANGE,
    "force_cutting_base": SKY,
    "force_thrust_base": AMBER,
    "stress_axial": BLUE,
    "stress_grip": GREY,
    "work_tool": BLACK,
    "energy_elastic": SKY,
    "energy_plastic": ORANGE,
    "energy_cohesive": GREEN,
    "energy_fracture": GREEN,
    "energy_friction": AMBER,
    "energy_contact": YELLOW,
    "energy_kinetic": BLUE,
    "energy_numerical": PURPLE,
    "energy_damping": GREY,
    "energy_residual": "#D0D0D0",
}

TENSION, SHEAR = BLUE, GREEN
"""Cracks in tension and in shear."""

SERIES = (BLUE, ORANGE, GREEN, PURPLE, AMBER, SKY, BLACK)
"""Values of a swept parameter, in increasing order."""

DISC_FACE, DISC_EDGE = "#EFE9DC", "#A89F8C"
TOOL_FACE, TOOL_EDGE = "#5B6770", "#2B3238"
