# The ladle turns about its lip A, drawn by a hook at B.
rows = 1
event(i) = "the surface reaches the bottom"
x = 9; y = 3.1; tilt = 0.5
eval polygon("0 0 -2.04 0 -2.04 -2.55 0 -2.55", x, y, -tilt, 0)
eval polygon("0 0 -2.04 -1.114 -2.04 -2.55 0 -2.55", x, y, -tilt, 1)
eval line(x - 3.2, y, x, y, DASHED) . ray(x, y, 3.2, 151.35, DASHED) . turning(x, y, 2.7, 180, 151.35)
eval right(x - 2.85, y + 0.75, "φ")
eval dot(x, y) . text(x, y + 0.4, "lip A") . dot(x - 3.01, y - 1.26) . right(x - 3.15, y - 1.5, "B")
eval line(x - 3.01, y - 1.26, x - 3.01, y - 0.2, FORCE) . right(x - 3.15, y - 0.5, "F_B")
eval line(x + 0.1, y - 0.1, x + 0.55, 0.9, MASS) . text(x + 0.6, 1.9, "metal, 1260 kg/s")
