# Undercarriage, house, jib and hook block of a crane. The jib stands on a cylinder, the block hangs on a rope.
rows = 2; scale = 0.54
event(i) = i == 0 ? "+1500 kg, leaks" : "−700 kg, leak closes"
row(i) = i; before(i) = i == 0
u(m) = 6 + scale * m; v(m) = 0.85 + scale * m
bar(a, b, c, d, style) = line(u(a), v(b), u(c), v(d), style)
cylinder(a, b, c, d) = spring(u(a), v(b), u(c), v(d))
outline(s, full) = polygon(s, u(0), v(0), 0, full)
eval ground(u(-4), u(9.5), v(-1)) . cylinder(-2, -1, -2, 0) . cylinder(2, -1, 2, 0)
eval outline("-2.4 0 2.4 0 2.4 0.9 -2.4 0.9", 0) . outline("-2.6 1.1 1.6 1.1 1.6 2.2 0.6 3 -2.6 3", 0)
eval outline("0.85 2.6 1.15 2.4 5.1 7.4 4.85 7.6", 0) . cylinder(1.5, 1.5, 3, 5)
eval bar(5, 7.5, 5.8, 3.5, OUTLINE) . outline("5.5 3.5 6.1 3.5 6.1 2.8 5.5 2.8", 0) . outline("5.2 2.8 6.4 2.8 6.6 1.6 5 1.6", 1)
eval pin(u(0), v(1)) . pin(u(1), v(2.5)) . pin(u(5), v(7.5)) . bar(1, 1.5, 1, 0.9, OUTLINE)
eval middle(u(0), v(0.45), "base") . middle(u(-1), v(2), "house") . right(u(2.5), v(5.4), "jib")
eval text(u(5.7), v(5.5), "rope") . text(u(7), v(3), "block and load") . bar(5.8, 1.6, 5.8, 0, MASS) . text(u(6.1), v(0.5), "leak, 40 kg/s")
eval bar(5, 3.15, 3.6, 3.15, DASHED) . bar(4, -1, 4, 3.15, QUANTITY) . right(u(3.8), v(1.4), "y")
