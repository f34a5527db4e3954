# A lever with a belt on its arm; its tilt moves the gate that feeds the belt.
rows = 0
x = 3.5; y = 2.6; tilt = -12 * DEG
ex = x + 4 * cos(tilt); ey = y + 4 * sin(tilt)
eval line(x, y, x + 7.5, y, DASHED) . support(x, y) . line(x, y, ex, ey, OUTLINE) . pin(x, y)
eval disc(ex - 1, ey, 0.3, 0) . disc(ex + 2, ey, 0.3, 0) . line(ex - 1, ey + 0.3, ex + 2, ey + 0.3, OUTLINE)
eval line(ex - 1, ey - 0.3, ex + 2, ey - 0.3, OUTLINE)
eval polygon("-0.6 0 1.8 0 1.6 0.35 -0.3 0.35", ex, ey + 0.3, 0, 1) . middle(ex + 0.5, ey + 1, "m")
eval polygon("-0.9 0.9 0.9 0.9 0.3 0 -0.3 0", ex - 0.6, 4, 0, 1) . line(ex - 0.6, 4, ex - 0.6, ey + 0.75, MASS)
eval text(ex - 0.4, 3.6, "q_{in}(θ)")
eval line(ex + 2.2, ey + 0.3, ex + 3, ey - 0.8, MASS) . text(ex + 3, ey - 0.3, "ν m")
eval spring(x + 1.4, y - 0.3, x + 1.4, 0.6) . ground(x + 0.9, x + 2, 0.6) . right(x + 1.1, 1.2, "k")
eval turning(x, y, 2.15, 0, -12) . middle(x + 2.1, y + 0.32, "θ")
