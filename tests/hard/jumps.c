static const hard_case jumps_cases[] = {{"x", C2_ours, C2_naive, 0, "", "", {0}}};
