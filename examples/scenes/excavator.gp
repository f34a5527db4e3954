# Base, house, jib, arm and scoop, joined by pins and held by cylinders, which are springs with dampers.
rows = 2; until = 10; scale = 0.8
event(i) = i == 0 ? "soil comes" : "full"
row(i) = i
u(m) = 5.6 + scale * m; v(m) = 1 + scale * m
bar(a, b, c, d, style) = line(u(a), v(b), u(c), v(d), style)
cylinder(a, b, c, d) = spring(u(a), v(b), u(c), v(d))
outline(s, full) = polygon(s, u(0), v(0), 0, full)
eval ground(u(-3), u(9), v(-1)) . cylinder(-1.5, -1, -1.5, 0) . cylinder(1.5, -1, 1.5, 0)
eval outline("-1.9 0 1.9 0 1.5 0.9 -1.5 0.9", 0) . outline("-2.2 1.1 1.2 1.1 1.2 1.5 1 2.1 0.3 3 -2.2 2.6", 0)
eval outline("0.9 1.9 2.3 3.6 4.4 4.35 4.5 4.1 2.7 3.1 1.1 1.9", 0)
eval outline("4.3 4.75 4.6 4.75 5.05 1.95 4.75 1.95 4.25 4.2", 0)
eval outline("4.7 2 5.3 2 5.7 1.1 5 0.5 4.4 0.9", 1) . cylinder(1.2, 1.4, 2.5, 3.1) . cylinder(3, 4.1, 4.4, 4.7)
eval cylinder(4.95, 3.5, 5.3, 1.8)
eval pin(u(0), v(1)) . pin(u(1), v(2)) . pin(u(4.4), v(4.2)) . pin(u(4.9), v(2)) . bar(1, 1, 1, 1.5, OUTLINE)
eval middle(u(0), v(0.45), "base") . middle(u(-0.8), v(1.9), "house") . right(u(2.1), v(3.9), "jib")
eval text(u(5), v(3.9), "arm") . text(u(7.4), v(2), "soil")
eval bar(7.3, 2, 5.7, 1.6, MASS) . bar(4.4, 0, 7, 0, DASHED) . bar(5.1, 1.2, 7, 1.2, DASHED)
eval bar(6.5, 0, 6.5, 1.2, QUANTITY) . text(u(6.9), v(0.6), "y")
