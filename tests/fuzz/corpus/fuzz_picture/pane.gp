set hidden3d area
set shadow
splot '-' solid translucent 'g'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v .2 .2 0
v .8 .2 0
v .8 .8 0
usemtl w
f 1 2 3 4 h 5 6 7
usemtl g
f 5 6 7
d 1 7
e
