# A bar with a vessel, which fills, on one arm and a weight on the other, which rests on a stop at first.
rows = 1
event(i) = i == 0 ? "the tap shuts: θ = 0.02" : i == 2 ? "largest angle" : ""
x = 8; y = 3; a = 10 * DEG; lx = x - 3.6 * cos(a); ly = y - 3.6 * sin(a); rx = x + 3.6 * cos(a); ry = y + 3.6 * sin(a)
eval line(x - 4.2, y, x + 4.4, y, DASHED) . polygon("0 0 0.5 -2.4 -0.5 -2.4", x, y, 0, 0)
eval ground(x - 1.2, x + 1.2, y - 2.4)
eval line(lx, ly, rx, ry, OUTLINE) . pin(x, y)
eval polygon("-0.9 0 0.9 0 0.9 -1.3 -0.9 -1.3", lx, ly - 0.35, 0, 0)
eval polygon("-0.9 -0.5 0.9 -0.5 0.9 -1.3 -0.9 -1.3", lx, ly - 0.35, 0, 1)
eval line(lx - 0.9, ly - 0.35, lx, ly, OUTLINE) . line(lx + 0.9, ly - 0.35, lx, ly, OUTLINE)
eval right(lx - 1.1, ly - 1, "m")
eval box(lx - 0.75, 4.5, lx - 0.45, 4.9, 0) . line(lx - 0.6, 4.5, lx - 0.6, ly - 0.85, MASS)
eval right(lx - 0.9, 4.3, "tap, q = 2 kg/s")
eval line(rx, ry, rx, ry - 0.8, OUTLINE) . box(rx - 0.5, ry - 1.5, rx + 0.5, ry - 0.8, 0)
eval text(rx + 0.7, ry - 1.1, "weight")
eval line(x + 2.4, 2, x + 2.4, y - 0.1, OUTLINE) . ground(x + 2, x + 2.8, 2) . text(x + 2.1, 1.4, "stop")
eval turning(x, y, 3, 180, 190) . right(x - 4.4, y, "θ")
eval line(x - 3.6, 3.4, x, 3.4, DISTANCE) . middle(x - 1.8, 3.8, "R")
