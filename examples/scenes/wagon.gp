# A wagon below a hopper.
rows = 1
event(i) = i == 0 ? "filled, begins to empty" : ""
x = 8; y = 0.95
eval ground(3, 13, y) . box(x - 1.8, y + 0.5, x + 1.8, y + 2, 0) . box(x - 1.8, y + 0.5, x + 1.8, y + 1.4, 1)
eval disc(x - 1.1, y + 0.3, 0.3, 0) . disc(x + 1.1, y + 0.3, 0.3, 0)
eval polygon("-0.9 0.8 0.9 0.8 0.25 0 -0.25 0", x, 4.1, 0, 1) . line(x, 4.05, x, y + 1.5, MASS)
eval text(x + 0.3, 3.5, "400 kg/s, first 60 s")
eval line(x, y + 0.5, x, y - 0.5, MASS) . text(x + 0.3, y - 0.6, "400 kg/s, after 60 s")
eval line(x + 1.8, y + 0.8, x + 3.3, y + 0.8, FORCE) . text(x + 3.4, y + 0.8, "F = 15 kN")
eval line(x + 1.8, y + 1.5, x + 3.3, y + 1.5, QUANTITY) . text(x + 3.5, y + 1.5, "v")
eval middle(x, y + 1, "M")
