# A platform with the wagon on it turns about its axle O.
rows = 2
event(i) = i == 0 ? "pours" : i == 1 ? "empty" : "stop: φ = 1.9"
row(i) = i == 2
before(i) = i == 1
x = 7; y = 1.1; tilt = 0.5
eval support(x, y) . line(x, y, x + 4.6, y, DASHED)
eval polygon("0.4 0 3.9 0 3.9 0.2 0.4 0.2", x, y, tilt, 0) . polygon("0.7 0.6 3.6 0.6 3.6 2 0.7 2", x, y, tilt, 0)
eval polygon("0.7 0.6 3.6 0.6 3.6 1.5 0.7 1.5", x, y, tilt, 1)
eval disc(x + 0.75, y + 0.85, 0.2, 0) . disc(x + 2.75, y + 1.95, 0.2, 0) . line(x, y, x + 0.45, y + 0.25, OUTLINE)
eval pin(x, y)
eval turning(x, y, 4.3, 0, 28.6) . text(x + 4.4, y + 1, "φ, ω = φ'")
eval torque(x, y, 0.9, 75, 170) . right(x - 1.1, y + 0.35, "T") . text(x + 0.6, y - 0.25, "O")
eval line(x - 0.35, y + 2, x - 1.4, y + 1.3, MASS) . right(x - 0.7, y + 2.2, "load m(φ)")
