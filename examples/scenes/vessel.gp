# The ladle turns about the trunnion P, driven by a motor.
rows = 2
event(i) = i == 0 ? "the surface reaches the bottom" : "stop: φ = 1.4"
row(i) = i
x = 8; y = 2.2; tilt = 0.5
eval polygon("1.02 1.19 -1.02 1.19 -1.02 -1.36 1.02 -1.36", x, y, -tilt, 0)
eval polygon("1.02 1.19 -1.02 0.0755 -1.02 -1.36 1.02 -1.36", x, y, -tilt, 1)
eval line(x, y, x, 4.75, DASHED) . ray(x, y, 2.6, 61.35, DASHED) . arc(x, y, 2.3, 61.35, 90, THIN)
eval middle(x + 0.6, y + 2.6, "φ")
eval disc(x, y, 0.16, 0) . text(x + 0.25, y - 0.1, "P")
eval torque(x, y, 0.6, 200, 60) . middle(x - 0.75, y - 0.55, "T")
eval turning(x, y, 2.1, 175, 125) . right(x - 2.1, y + 1.2, "ω = φ'")
eval line(x + 1.55, y + 0.75, x + 2.1, 0.7, MASS) . text(x + 2.2, 1.6, "metal")
