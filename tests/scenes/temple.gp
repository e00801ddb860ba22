# Solids and wire frames: a temple of convex parts, which touch each other, and masts of struts in front of it and behind.
set title "temple.obj, perspective"
set view from 34,-26,13 to 5,8,4
splot 'temple.obj', 'mast.obj' translate 15.5,3,0, 'mast.obj' scale 1,1,1.2 translate -4,18,0
