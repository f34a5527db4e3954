# Strip from drum 1 through the rolls onto drum 3.
rows = 1
event(i) = "25 m rolled"
y = 2
eval disc(3.5, y, 1.5, 1) . disc(3.5, y, 0.5, 0) . disc(12.5, y, 1, 1) . disc(12.5, y, 0.5, 0)
eval disc(8, 3.67, 0.42, 0) . disc(8, 2.83, 0.42, 0) . line(3.5, 3.5, 8, 3.25, OUTLINE)
eval line(8, 3.25, 12.5, 3, OUTLINE)
eval middle(3.5, 0.2, "drum 1") . middle(12.5, 0.6, "drum 3") . middle(8, 2, "rolls, F_r")
eval line(4.6, 3.8, 6.2, 3.71, QUANTITY) . middle(5.4, 4.2, "v_1") . text(6.3, 2.95, "h_1") . text(9.6, 2.8, "h_2")
eval torque(3.5, y, 1.75, 100, 160) . right(1.6, 3, "T_b") . torque(12.5, y, 1.3, 85, 15) . text(13.8, 2.9, "T_3")
