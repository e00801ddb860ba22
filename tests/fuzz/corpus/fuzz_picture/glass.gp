set hidden3d area outline
set hatch 45,2
set shadow outline
set light 3 1,2,3
set crease 20
set pen shadow 2 detail 3 hidden 4
splot '-' solid translucent, '-' solid, x*y
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 1
f 1 2 3 4
d 1 3 2
e
v 0 0 1
v 1 0 1
v 1 1 2
f 1 2 3
e
