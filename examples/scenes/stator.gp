# The rest of a broken rotor in its stator: W is the centre of its shaft, S_1 its mass centre.
rows = 1
event(i) = "touches the stator"
x = 8; y = 2.5; wx = x + 0.5; wy = y + 0.3; psi = 35; sx = wx - 0.8 * cos(psi * DEG); sy = wy - 0.8 * sin(psi * DEG)
eval disc(x, y, 2.45, 0) . disc(x, y, 2.25, 0)
eval arc(wx, wy, 1.35, psi + 45, psi + 315, OUTLINE)
eval line(wx + 1.35 * cos(80 * DEG), wy + 1.35 * sin(80 * DEG), wx + 1.35 * cos(10 * DEG), wy + 1.35 * sin(-10 * DEG), OUTLINE)
eval line(sx, sy, sx + 3.6, sy, DASHED) . ray(sx, sy, 3.6, psi, DASHED) . line(sx, sy, wx, wy, OUTLINE) . dot(sx, sy)
eval pin(wx, wy)
eval turning(sx, sy, 3.1, 0, psi) . text(sx + 3.3, sy + 0.9, "ψ")
eval middle(wx + 0.1, wy + 0.45, "W") . line(4.7, 2.5, sx - 0.12, sy, THIN) . right(4.6, 2.5, "mass centre S_1") . middle(sx + 0.15, sy + 0.5, "s")
eval line(4.7, 4.3, x - 1.75, 4.05, THIN) . right(4.6, 4.35, "stator") . line(4.7, 1.2, wx - 1.22, wy - 0.58, THIN)
eval right(4.6, 1.1, "rest of the rotor")
