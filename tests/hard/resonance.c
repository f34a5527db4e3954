static const hard_case resonance_cases[] = {{"x", C2_ours, C2_naive, 0, "", "", {0}}};
