static const hard_case stiffness_cases[] = {{"x", C2_ours, C2_naive, 0, "", "", {0}}};
