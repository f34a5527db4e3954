# A crank moves a wagon, which fills on its way out and empties on its way back.
rows = 1
event(i) = i == 0 ? "turns back: θ = π" : "one turn"
x = 4.5; y = 1.9; px = x + 1.3 * cos(110 * DEG); py = y + 1.3 * sin(110 * DEG)
eval arc(x, y, 1.3, 0, 359.9, DASHED) . line(x - 2.2, y, x, y, DASHED)
eval line(x, y, px, py, OUTLINE) . line(px, py, 10, 1.9, OUTLINE) . support(x, y) . pin(px, py)
eval turning(x, y, 1.75, 180, 112) . right(x - 1.5, y + 1.3, "θ, ω = θ'")
eval torque(x, y, 0.6, 75, -60) . text(x + 0.75, y - 0.15, "T") . right(x - 0.4, y + 0.55, "r")
eval ground(8.4, 14.5, 1) . box(10, 1.5, 13, 2.9, 0) . box(10, 1.5, 13, 2.2, 1) . disc(10.7, 1.3, 0.3, 0)
eval disc(12.3, 1.3, 0.3, 0) . pin(10, 1.9)
eval line(11.5, 4.3, 11.5, 2.3, MASS) . text(11.7, 3.7, "on the way out")
eval line(11.5, 1.5, 11.5, 0.3, MASS) . text(11.7, 0.35, "on the way back")
