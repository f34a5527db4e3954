# The arm hangs from a pin; the scoop cuts soil on its way up.
rows = 1
event(i) = i == 0 ? "full at φ = 0.6" : "bottom opens at φ = 1.6"
x = 7.2; y = 4.1
eval polygon("-1.83 -2.63 -1.2 -2.95 -0.6 -3.14 0 -3.2 0.6 -3.14 1.2 -2.95 1.83 -2.63", x, y, 0, 1)
eval ground(2.8, x - 1.83, y - 2.63) . ground(x + 1.83, 12.1, y - 2.63)
eval arc(x, y, 3.2, 302, 362, DASHED)
eval line(x, y, x, y - 2.5, DASHED) . line(x, y, 9.9, y - 1.83, OUTLINE)
eval polygon("0 0.35 0.75 0.35 0.75 -0.3 0 -0.3", 9.8, y - 1.72, -0.6, 1)
eval disc(x, y, 0.2, 0)
eval turning(x, y, 1.55, 272, 322) . right(x - 0.25, y - 1.4, "φ, ω = φ'")
eval torque(x, y, 0.65, 150, 300) . right(x - 0.75, y, "T")
eval text(11, 2.5, "soil") . line(3.8, 2.1, x - 1.1, y - 2.75, THIN) . middle(3.7, 2.35, "soil to cut")
