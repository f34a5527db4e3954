# A ring with the wagon in it turns about its axle O.
rows = 2
event(i) = i == 0 ? "pours" : i == 1 ? "empty" : "stop: φ = 2.9"
row(i) = i == 2
before(i) = i == 1
x = 8; y = 2.45; tilt = 0.5
eval disc(x, y, 2, 0)
eval polygon("-1.1 -1.5 1.1 -1.5 1.1 0.2 -1.1 0.2", x, y, tilt, 0)
eval polygon("-1.1 -1.5 1.1 -1.5 1.1 -0.3 -1.1 -0.3", x, y, tilt, 1)
eval line(x, y, x, 0.1, DASHED) . ray(x, y, 2.35, -90 + tilt / DEG, DASHED) . middle(x + 0.65, 0, "φ")
eval pin(x, y) . middle(x - 0.45, y + 0.25, "O")
eval torque(x, y, 0.95, 60, 150) . middle(x, y + 1.25, "T")
eval turning(x, y, 2.3, 5, 50) . text(x + 2.35, y + 1.1, "ω = φ'")
eval line(x - 1.05, y - 0.35, x - 2.9, y - 1.5, MASS) . right(x - 2.5, y - 0.6, "load m(φ)")
