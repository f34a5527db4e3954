# A chain with a mass at its end winds on a fixed drum.
rows = 1
event(i) = "2 m wound up"
x = 5.5; y = 2.5; a = -70 * DEG; sx = x + cos(a); sy = y + sin(a)
eval disc(x, y, 0.9, 0) . dot(x, y) . line(x, y, x + 0.9 * cos(a), y + 0.9 * sin(a), THIN)
eval text(x + 0.25, y - 0.3, "R")
do for [k = 1:8] { eval disc(x + cos(a - 0.21 * k), y + sin(a - 0.21 * k), 0.1, 0) }
do for [k = 0:22] { eval disc(sx - 0.21 * k * sin(a), sy + 0.21 * k * cos(a), 0.1, 1) }
eval disc(sx - 5 * sin(a), sy + 5 * cos(a), 0.38, 0) . text(sx + 5.2, sy + 1.7, "end mass")
eval text(sx + 2.8, sy + 0.55, "l = 3 m − R φ")
eval ray(x, y, 2, -166, DASHED) . ray(x, y, 2, -70, DASHED) . arc(x, y, 1.7, -166, -70, THIN)
eval right(x - 1.1, y - 1.7, "φ")
eval turning(x, y, 3.4, 10, 38) . text(x + 3.3, y + 1.7, "ω = φ'")
